//! The machine on which a report is made.

use restitution_table::{Cell, Table};

/// What decides how fast something runs.
#[derive(Clone, Debug)]
pub struct Machine {
    rows: Vec<(&'static str, String)>,
}

impl Machine {
    /// Asks the system and the build.
    pub fn this() -> Self {
        let mut system = sysinfo::System::new();
        system.refresh_cpu_all();
        let cpu = system.cpus().first().map(|cpu| cpu.brand().trim().to_owned()).unwrap_or_default();
        let cpu = if cpu.is_empty() { std::env::consts::ARCH.to_owned() } else { cpu };
        let os = sysinfo::System::long_os_version().unwrap_or_else(|| std::env::consts::OS.to_owned());
        let kernel = sysinfo::System::kernel_version().unwrap_or_default();
        let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
        Self {
            rows: vec![
                ("processor", cpu),
                ("cores", cores.to_string()),
                ("system", format!("{os}, kernel {kernel}")),
                ("compiler", env!("RESTITUTION_RUSTC").to_owned()),
                ("target", env!("RESTITUTION_TARGET").to_owned()),
                ("optimisation", format!("level {}", env!("RESTITUTION_OPTIMISATION"))),
                ("instructions", instructions()),
                ("version", format!("restitution {}", env!("CARGO_PKG_VERSION"))),
            ],
        }
    }

    /// Returns one of the things it says; nothing if it says nothing of it.
    pub fn of(&self, what: &str) -> String {
        self.rows.iter().find(|row| row.0 == what).map_or(String::new(), |row| row.1.clone())
    }

    /// Returns a sentence that names it.
    pub fn sentence(&self) -> String {
        let parts = self.rows.iter().map(|(name, value)| format!("{name}: {value}")).collect::<Vec<_>>();
        let warning = if env!("RESTITUTION_OPTIMISATION") == "3" {
            ""
        } else {
            " The command was built without full optimisation: its times are not those of a release build."
        };
        format!("Measured on this machine in one run. {}.{warning}", parts.join("; "))
    }

    /// Returns it as a table.
    pub fn table(&self) -> Table {
        let mut table = Table::new(&["what", "value"]);
        self.rows.iter().for_each(|(name, value)| table.push(vec![(*name).into(), Cell::text(value)]));
        table
    }
}

/// The instructions beyond the target's least that the build may use, of those that matter here.
fn instructions() -> String {
    let beyond = [
        ("sse4.1", cfg!(target_feature = "sse4.1")),
        ("avx", cfg!(target_feature = "avx")),
        ("avx2", cfg!(target_feature = "avx2")),
        ("fma", cfg!(target_feature = "fma")),
        ("avx512f", cfg!(target_feature = "avx512f")),
    ];
    let own = beyond.into_iter().filter(|(_, allowed)| *allowed).map(|(name, _)| name).collect::<Vec<_>>();
    if own.is_empty() { "those of every processor of the target".to_owned() } else { own.join(", ") }
}
