//! The table of what follows from a contact.

use crate::{Cell, CliError, Table};
use restitution::codes::ConstantRestitution;
use restitution::{Contact, End, Material, Validity, Verdict, ViscoelasticContact};

/// What is known about a contact.
pub(super) struct Report {
    pub(super) contact: Contact,
    pub(super) pair: Option<ViscoelasticContact>,
    pub(super) material: Option<Material>,
    /// The shorter Rayleigh time of the spheres, in s.
    pub(super) rayleigh: Option<f64>,
    pub(super) end: End,
    pub(super) error: Option<f64>,
    /// In s.
    pub(super) time_step: Option<f64>,
}

impl Report {
    /// The whole table; velocities come with the text they were typed as.
    pub(super) fn table(&self, velocities: &[(String, f64)]) -> Result<Table, CliError> {
        let mut rows =
            Rows(Table::new(&["velocity", "quantity", "symbol", "value", "unit", "note"]), String::new());
        self.add_contact(&mut rows);
        if let Some(pair) = &self.pair {
            rows.add("dissipative constant", "A", pair.dissipative_constant(), "s", "");
            if pair.dissipative_constant() > 0.0 {
                let g_star = pair.characteristic_velocity().map_err(CliError::usage)?;
                rows.add("characteristic velocity", "g*", g_star, "m/s", "eq. 31");
            }
            for (text, velocity) in velocities {
                rows.1.clone_from(text);
                self.add_collision(&mut rows, pair, *velocity)?;
            }
        }
        Ok(rows.0)
    }

    fn add_contact(&self, rows: &mut Rows) {
        rows.add("effective radius", "R_eff", self.contact.effective_radius(), "m", "");
        rows.add("effective mass", "m_eff", self.contact.effective_mass(), "kg", "");
        rows.add("effective modulus", "E", self.contact.effective_modulus(), "Pa", "");
        rows.add("force prefactor", "rho", self.contact.force_prefactor(), "N/m^(3/2)", "eq. 2");
        if let Some(material) = &self.material {
            rows.add("sound speed", "c", material.sound_speed(), "m/s", "thin bar");
        }
    }

    fn add_collision(&self, rows: &mut Rows, pair: &ViscoelasticContact, g: f64) -> Result<(), CliError> {
        let usage = CliError::usage;
        let end = match self.end {
            End::ZeroCompression => "to zero compression",
            End::ZeroForce => "to zero force",
        };
        rows.add("damping parameter", "u", pair.u(g).map_err(usage)?, "", "");
        rows.add("dissipation coefficient", "delta", pair.delta(g).map_err(usage)?, "", "eq. 14");
        rows.add("restitution", "epsilon", pair.epsilon(g, self.end).map_err(usage)?, "", end);
        if let Some(course) = pair.course(g, self.end).map_err(usage)? {
            rows.add("duration", "t_c", course.duration, "s", end);
            rows.add("maximal compression", "xi_max", course.maximal_compression, "m", "");
        }
        let undamped = "without damping";
        rows.add("duration", "2 T tau", pair.elastic_duration(g).map_err(usage)?, "s", undamped);
        rows.add("maximal compression", "xi_0", pair.elastic_compression(g).map_err(usage)?, "m", undamped);
        if let Some(material) = &self.material {
            let validity = Validity::of(pair, material, g).map_err(usage)?;
            for ((name, ratio), symbol) in validity.ratios().into_iter().zip(["g/c", "A/t_c", "a/R_eff"]) {
                rows.add(name, symbol, ratio, "", says(Verdict::of(ratio)));
            }
        }
        self.add_time_step(rows, pair, g)
    }

    fn add_time_step(&self, rows: &mut Rows, pair: &ViscoelasticContact, g: f64) -> Result<(), CliError> {
        let usage = CliError::usage;
        let step = match (self.error, self.time_step) {
            (Some(error), _) => {
                let step = pair.time_step_for(g, error).map_err(usage)?;
                rows.add("time step", "dt", step.seconds, "s", &format!("error of epsilon at most {error}"));
                step
            }
            (None, Some(seconds)) => {
                let step = pair.time_step(g, seconds).map_err(usage)?;
                rows.add("time step", "dt", seconds, "s", "");
                rows.add("error of epsilon", "d_eps", step.error, "", "at most");
                step
            }
            (None, None) => return Ok(()),
        };
        rows.add("time step / time unit", "dt/tau", step.per_time_unit, "", "");
        if let Some(rayleigh) = self.rayleigh {
            rows.add("Rayleigh time", "t_R", rayleigh, "s", "of the smaller or stiffer sphere");
            rows.add("time step / Rayleigh time", "dt/t_R", step.share_of(rayleigh), "", "");
        }
        Ok(())
    }
}

/// The table of a law whose coefficient does not depend on velocity.
pub(super) fn constant_law(law: &ConstantRestitution, ends: &[End]) -> Table {
    let mut rows = Rows(Table::new(&["quantity", "symbol", "value", "note"]), String::new());
    for end in ends {
        let note = if *end == End::ZeroForce { "to zero force" } else { "to zero compression" };
        rows.0.push(vec![
            "restitution".into(),
            "epsilon".into(),
            Cell::rounded(law.epsilon(*end), 10),
            note.into(),
        ]);
    }
    rows.0.note("This input damps with xi^(1/4): the coefficient is the same at every velocity, unlike that of a viscoelastic body.");
    rows.0
}

fn says(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Holds => "much smaller than 1: holds",
        Verdict::Doubtful => "not much smaller than 1: doubtful",
        Verdict::Violated => "should be much smaller than 1: violated",
    }
}

/// A table and the velocity of the rows that are being added.
struct Rows(Table, String);

impl Rows {
    fn add(&mut self, quantity: &str, symbol: &str, value: f64, unit: &str, note: &str) {
        let velocity = self.1.as_str().into();
        let cells = vec![
            velocity,
            quantity.into(),
            symbol.into(),
            Cell::rounded(value, 10),
            unit.into(),
            note.into(),
        ];
        self.0.push(cells);
    }
}
