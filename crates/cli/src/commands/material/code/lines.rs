//! The lines to paste into the input of a code, and what is said above them.

use super::pairs::{self, Pair};
use super::request::{Dissipation, Request};
use super::{Code, constant, rebound};
use crate::CliError;
use restitution::codes::{
    Chrono, EsysParticle, LammpsGranular, LammpsHertzHistory, Liggghts, MercuryDpm, UnitSystem, Yade,
};
use restitution::{Contact, End, MaterialError, ViscoelasticContact};

impl Request<'_> {
    /// The lines for `code`.
    ///
    /// # Errors
    ///
    /// Usage for what is missing, and for what the code does not have.
    pub(in crate::commands) fn lines(&self, code: Code) -> Result<String, CliError> {
        let end = code.end(self.end)?;
        if let Some(lines) = self.without_bodies(code)? {
            return Ok(lines);
        }
        let pair = self.pair(end)?;
        self.check(code)?;
        if let Some(constant) = code.constant() {
            let law = constant::law(self, end)?;
            return Ok(self.remarks(code, &pair, end, &[])?
                + &constant::lines(constant, self, &law, pair.contact(), end)?);
        }
        let pairs = if code.multiplies_mass() { pairs::of(self, &pair)? } else { None };
        match pairs {
            Some(pairs) => {
                Ok(self.remarks(code, &pair, end, &pairs)? + &unlike(code, &pairs, end, self.units)?)
            }
            None => Ok(self.remarks(code, &pair, end, &[])? + &self.text(code, &pair, end)?),
        }
    }

    /// YADE and REBOUND need the coefficient and its velocity alone, whatever the bodies are.
    fn without_bodies(&self, code: Code) -> Result<Option<String>, CliError> {
        if code == Code::Rebound {
            return rebound::lines(self).map(Some);
        }
        let Dissipation::Given(args) = &self.dissipation else { return Ok(None) };
        if code != Code::Yade || !self.velocities.is_empty() {
            return Ok(None);
        }
        let Some(measured) = args.measured()? else { return Ok(None) };
        let input = Yade::measured(measured.loss.epsilon(), measured.loss.velocity(), 1.0);
        let input = input.map_err(CliError::usage)?;
        let lines = input.to_string();
        let line = lines.lines().last().unwrap_or_default();
        let text = &measured.text;
        Ok(Some(format!("# SI units; any bodies, the contact ends at zero force\n# {text}\n{line}\n")))
    }

    /// Refuses what the code does not have.
    fn check(&self, code: Code) -> Result<(), CliError> {
        if self.units != UnitSystem::Si && !code.has_units() {
            return Err(CliError::usage("this code's lines are in SI units: leave --units out"));
        }
        if self.units == UnitSystem::Reduced && (self.bodies.has_units() || self.dissipation.has_units()) {
            return Err(CliError::usage(
                "units lj are numbers without units: give bare numbers, all scaled alike",
            ));
        }
        if code == Code::Esys && self.bodies.is_plane() {
            return Err(CliError::usage(
                "ESyS-Particle has no viscoelastic wall: make the wall of spheres that do not move, and leave --against out",
            ));
        }
        if code == Code::TrixiParticles && self.bodies.is_plane() {
            return Err(CliError::usage(
                "TrixiParticles moves particles out of its walls by half the overlap at every step, so that no coefficient belongs to them: leave --against out",
            ));
        }
        Ok(())
    }

    /// What the lines below are for: units, bodies, end of contact, and a coefficient to check a run against.
    fn remarks(
        &self,
        code: Code,
        pair: &ViscoelasticContact,
        end: End,
        pairs: &[Pair],
    ) -> Result<String, CliError> {
        let sign = code.remark();
        let ends = if end == End::ZeroForce { "zero force" } else { "zero compression" };
        let (units, scope) = (self.units.name(), self.bodies.scope());
        let mut said = vec![match pairs {
            [] => format!(
                "units {units}; for {scope}: {}; the contact ends at {ends}",
                self.size(pair.contact())
            ),
            _ => format!("units {units}; for {scope}, types 1 and 2; the contact ends at {ends}"),
        }];
        for Pair { types: [one, other], contact } in pairs {
            let size = self.size(contact.contact());
            said.push(format!("pair {one} {other}: {size}, {}", self.at_g_star(contact, end)?));
        }
        let measured = match &self.dissipation {
            Dissipation::Given(args) => args.measured()?.map(|measured| measured.text),
            Dissipation::Fitted { says, .. } => Some(says.clone()),
        };
        let fitted = matches!(self.dissipation, Dissipation::Fitted { .. });
        let check = measured.is_none() || fitted;
        if code.constant().is_some() {
            said.extend(measured.map(|text| format!("{text}, and the same at every velocity")));
            if self.bodies.two_materials()?.is_some_and(|(_, other)| other.is_some())
                && !self.bodies.is_plane()
            {
                said.push("measured between 1 and 2; among themselves both are given the same".to_owned());
            }
        } else {
            said.extend(measured);
        }
        if check && pairs.is_empty() {
            said.push(self.at_g_star(pair, end)?);
        }
        if let [_] = pairs {
            said.push("of pairs 1 1 and 2 2 nothing is known: measure them too, or give --dissipative-constant and --dissipative-constant2".to_owned());
        }
        if code == Code::LammpsHertzHistory && !pairs.is_empty() {
            said.push("this style has one damping for all pairs, here that of 1 2: --code lammps gives a line for each".to_owned());
        } else if code.multiplies_mass() && pairs.is_empty() {
            said.push("the damping below multiplies the mass: it is right for this m_eff alone".to_owned());
        }
        said.extend(code.read_not_run().map(|file| format!("read in the source ({file}), not run")));
        Ok(said.iter().map(|line| format!("{sign} {line}\n")).collect())
    }

    fn size(&self, contact: &Contact) -> String {
        let (metre, kilogram) = if self.units == UnitSystem::Reduced { ("", "") } else { (" m", " kg") };
        format!(
            "R_eff = {:?}{metre}, m_eff = {:?}{kilogram}",
            contact.effective_radius(),
            contact.effective_mass()
        )
    }

    fn at_g_star(&self, pair: &ViscoelasticContact, end: End) -> Result<String, CliError> {
        let Ok(g_star) = pair.characteristic_velocity() else { return Ok("epsilon = 1".to_owned()) };
        let speed = if self.units == UnitSystem::Reduced { "" } else { " m/s" };
        let epsilon = pair.epsilon(g_star, end).map_err(CliError::usage)?;
        Ok(format!("epsilon = {epsilon:.6} at g* = {g_star:.6e}{speed}"))
    }

    fn text(&self, code: Code, pair: &ViscoelasticContact, end: End) -> Result<String, CliError> {
        let (wall, units) = (self.bodies.is_plane(), self.units);
        let text = match code {
            Code::LammpsHertzHistory => LammpsHertzHistory::new(pair)
                .map(|input| input.in_units(units))
                .map(|input| if wall { input.wall_line() } else { input.to_string() }),
            Code::Liggghts => Liggghts::new(pair, end).map(|input| input.in_units(units)).map(|input| {
                if wall { format!("{input}\n{}", input.wall_line()) } else { input.to_string() }
            }),
            Code::Mercury => Ok(MercuryDpm::new(pair).to_string()),
            Code::Esys => {
                let poisson = self
                    .bodies
                    .poisson()
                    .ok_or_else(|| CliError::usage("ESyS-Particle wants Poisson's ratio: give --poisson"))?;
                EsysParticle::new(pair, poisson).map(|input| input.to_string())
            }
            Code::Chrono => {
                Chrono::new(pair).map(|input| if wall { on_a_plane(&input, pair) } else { input.to_string() })
            }
            Code::Yade => {
                let [vn] = self.velocities.as_slice() else {
                    return Err(CliError::usage(
                        "YADE wants the velocity vn at which it is told the coefficient: give one --velocity",
                    ));
                };
                Yade::new(pair, vn.to_f64()).map(|input| input.to_string())
            }
            _ => LammpsGranular::new(pair, end)
                .map(|input| input.in_units(units))
                .map(|input| if wall { input.wall_line() } else { input.to_string() }),
        };
        Ok(text.map_err(CliError::usage)? + "\n")
    }
}

/// Chrono knows no radius of a contact with a plane, and takes the plane's mass as it is.
fn on_a_plane(input: &Chrono, pair: &ViscoelasticContact) -> String {
    format!(
        "ChCollisionInfo::SetDefaultEffectiveCurvatureRadius({:?});  // Chrono has 0.1 m for a plane\n{input}\n// give the fixed body of the plane a mass far above that of the spheres: Chrono counts it",
        pair.contact().effective_radius()
    )
}

/// The lines of two unlike types, whose damping multiplies the mass.
fn unlike(code: Code, pairs: &[Pair], end: End, units: UnitSystem) -> Result<String, CliError> {
    let granular = |pair: &Pair| LammpsGranular::new(&pair.contact, end).map(|input| input.in_units(units));
    let met = pairs.iter().find(|pair| pair.types == [1, 2]);
    let text = match (code, pairs, met) {
        (Code::Liggghts, [one, met, other], _) => {
            let input = |pair: &Pair| Liggghts::new(&pair.contact, end).map(|input| input.in_units(units));
            let all = [input(one), input(met), input(other)].into_iter().collect::<Result<Vec<_>, _>>();
            all.map(|all| Liggghts::lines_of_two_types([all[0], all[1], all[2]]))
        }
        (Code::Liggghts, ..) => {
            return Err(CliError::usage(
                "LIGGGHTS wants all pairs at once, and one measurement of two materials is that of one pair: give --dissipative-constant and --dissipative-constant2",
            ));
        }
        (Code::LammpsHertzHistory, _, Some(met)) => {
            LammpsHertzHistory::new(&met.contact).map(|input| input.in_units(units).to_string())
        }
        (Code::Chrono, _, Some(met)) => Chrono::new(&met.contact).map(|input| {
            format!("// for pair 1 2: Chrono takes the means of kn and gn of two materials, which for other pairs are other numbers\n{input}")
        }),
        _ => {
            let lines = pairs.iter().map(|pair| {
                let [one, other] = pair.types;
                granular(pair).map(|input| input.pair_line(&format!("{one} {other}")))
            });
            let lines: Result<Vec<_>, MaterialError> = lines.collect();
            lines.map(|lines| format!("pair_style granular\n{}", lines.join("\n")))
        }
    };
    Ok(text.map_err(CliError::usage)? + "\n")
}
