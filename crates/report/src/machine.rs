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
                ("version", format!("restitution {}", env!("CARGO_PKG_VERSION"))),
            ],
        }
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
