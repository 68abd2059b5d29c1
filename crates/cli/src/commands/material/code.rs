//! The inputs of discrete-element codes, there and back.

use super::{MaterialArgs, end_of};
use crate::CliError;
use crate::args::EndOfContact;
use crate::exact::Exact;
use crate::units::{Dimension, Quantity};
use restitution::codes::{
    ConstantRestitution, EsysParticle, LammpsGranular, LammpsHertzHistory, Liggghts, MercuryDpm, UnitSystem,
    Yade,
};
use restitution::{End, MaterialError, ViscoelasticContact};

/// A discrete-element code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum Code {
    /// LAMMPS, pair_style granular, hertz with damping viscoelastic.
    Lammps,
    /// LAMMPS, pair_style gran/hertz/history.
    LammpsHertzHistory,
    /// LAMMPS, pair_style granular with damping coeff_restitution: the same coefficient at every velocity.
    LammpsConstant,
    /// LIGGGHTS, model hertz: the same coefficient at every velocity.
    LiggghtsConstant,
    /// LIGGGHTS, pair_style gran model hertz/stiffness.
    Liggghts,
    /// YADE, Ip2_FrictMat_FrictMat_MindlinPhys with en and vn.
    Yade,
    /// MercuryDPM, HertzianBSHPViscoelastic.
    Mercury,
    /// ESyS-Particle, HertzianViscoElasticPrms.
    Esys,
}

impl Code {
    /// The lines to paste for the contact of the arguments.
    pub(super) fn lines(self, args: &MaterialArgs) -> Result<String, CliError> {
        let end = self.end(args.end)?;
        if let Some(lines) = self.without_bodies(args)? {
            return Ok(lines);
        }
        let contact = args.bodies.contact()?;
        let pair = args.damping.pair(&args.bodies, contact, end)?.ok_or_else(|| {
            CliError::usage("nothing says how the material dissipates: give --dissipative-constant, --eta1 and --eta2, --measured or --g-star")
        })?;
        self.check(args)?;
        Ok(self.remarks(args, &pair, end)? + &self.text(args, &pair, end)?)
    }

    /// YADE needs the coefficient and its velocity alone, whatever the bodies are.
    fn without_bodies(self, args: &MaterialArgs) -> Result<Option<String>, CliError> {
        let (Self::Yade, Some((velocity, epsilon)), []) =
            (self, args.damping.measured(), args.velocity.as_slice())
        else {
            return Ok(None);
        };
        let input = Yade::measured(epsilon.to_f64(), velocity.to_f64(), 1.0).map_err(CliError::usage)?;
        let lines = input.to_string();
        let line = lines.lines().last().unwrap_or_default();
        Ok(Some(format!(
            "# SI units; any bodies, the contact ends at zero force\n# epsilon = {epsilon} at {velocity}\n{line}\n"
        )))
    }

    /// Refuses what the code does not have.
    fn check(self, args: &MaterialArgs) -> Result<(), CliError> {
        let units = args.unit_system();
        if units != UnitSystem::Si && !self.multiplies_mass() {
            return Err(CliError::usage("this code's lines are in SI units: leave --units out"));
        }
        if units == UnitSystem::Reduced && (args.bodies.has_units() || args.damping.has_units()) {
            return Err(CliError::usage(
                "units lj are numbers without units: give bare numbers, all scaled alike",
            ));
        }
        if self == Self::Esys && args.bodies.is_plane() {
            return Err(CliError::usage(
                "ESyS-Particle has no viscoelastic wall: make the wall of spheres that do not move, and leave --against out",
            ));
        }
        Ok(())
    }

    /// What the lines below are for: units, bodies, end of contact, and a coefficient to check a run against.
    fn remarks(self, args: &MaterialArgs, pair: &ViscoelasticContact, end: End) -> Result<String, CliError> {
        let sign = if self == Self::Mercury { "//" } else { "#" };
        let contact = pair.contact();
        let ends = if end == End::ZeroForce { "zero force" } else { "zero compression" };
        let units = args.unit_system();
        let reduced = units == UnitSystem::Reduced;
        let (metre, kilogram, speed) = if reduced { ("", "", "") } else { (" m", " kg", " m/s") };
        let mut out = format!(
            "{sign} units {}; for {}: R_eff = {:?}{metre}, m_eff = {:?}{kilogram}; the contact ends at {ends}\n",
            units.name(),
            args.bodies.scope(),
            contact.effective_radius(),
            contact.effective_mass(),
        );
        if let Some((velocity, epsilon)) = args.damping.measured() {
            out += &format!("{sign} epsilon = {epsilon} at {velocity}\n");
        } else if let Ok(g_star) = pair.characteristic_velocity() {
            let epsilon = pair.epsilon(g_star, end).map_err(CliError::usage)?;
            out += &format!("{sign} epsilon = {epsilon:.6} at g* = {g_star:.6e}{speed}\n");
        }
        if self.multiplies_mass() {
            out +=
                &format!("{sign} the damping below multiplies the mass: it is right for this m_eff alone\n");
        }
        Ok(out)
    }

    fn multiplies_mass(self) -> bool {
        matches!(self, Self::Lammps | Self::LammpsHertzHistory | Self::Liggghts)
    }

    /// The lines of a law with the same coefficient at every velocity, which a measured pair gives.
    fn constant(self, args: &MaterialArgs, pair: &ViscoelasticContact, end: End) -> Result<String, CliError> {
        let Some((_, epsilon)) = args.damping.measured() else {
            return Err(CliError::usage("a constant coefficient is one that was measured: give --measured"));
        };
        let law = ConstantRestitution::that_gives(epsilon.to_f64(), end).map_err(CliError::usage)?;
        let nominal = format!("{:.9}", law.epsilon(End::ZeroCompression));
        let nominal = nominal.trim_end_matches('0');
        let (limited, modulus) = (end == End::ZeroForce, pair.contact().effective_modulus());
        let wall = args.bodies.is_plane();
        if self == Self::LammpsConstant {
            let limit = if limited { " limit_damping" } else { "" };
            let k_n = 4.0 / 3.0 * modulus;
            let model = format!(
                "hertz {k_n:e} {nominal} tangential linear_nohistory 0 0 damping coeff_restitution{limit}"
            );
            return Ok(match wall {
                true => format!("fix wall all wall/gran granular {model} zplane 0.0 NULL\n"),
                false => format!("pair_style granular\npair_coeff * * {model}\n"),
            });
        }
        let limit = if limited { "on" } else { "off" };
        let model = "model hertz tangential no_history";
        let poisson = args.bodies.poisson().unwrap_or(0.3);
        let young = 2.0 * modulus * (1.0 - poisson) * (1.0 + poisson);
        let young = format!("{young:.14e}").parse().unwrap_or(young); // the last digits are rounding
        let hard = if young > 1e9 { "hard_particles yes\n" } else { "" }; // else refused
        let mut lines = format!("{hard}pair_style gran {model} limitForce {limit}\npair_coeff * *\n");
        lines += &format!("fix young all property/global youngsModulus peratomtype {young:e}\n");
        lines += &format!("fix poisson all property/global poissonsRatio peratomtype {poisson}\n");
        lines += &format!("fix cor all property/global coefficientRestitution peratomtypepair 1 {nominal}\n");
        lines += "fix friction all property/global coefficientFriction peratomtypepair 1 0\n";
        if wall {
            lines +=
                &format!("fix wall all wall/gran {model} primitive type 1 zplane 0.0 limitForce {limit}\n");
        }
        Ok(lines)
    }

    fn text(self, args: &MaterialArgs, pair: &ViscoelasticContact, end: End) -> Result<String, CliError> {
        let (wall, units) = (args.bodies.is_plane(), args.unit_system());
        let text = match self {
            Self::Lammps => LammpsGranular::new(pair, end)
                .map(|input| input.in_units(units))
                .map(|input| if wall { input.wall_line() } else { input.to_string() }),
            Self::LammpsHertzHistory => LammpsHertzHistory::new(pair)
                .map(|input| input.in_units(units))
                .map(|input| if wall { input.wall_line() } else { input.to_string() }),
            Self::Liggghts => Liggghts::new(pair, end).map(|input| input.in_units(units)).map(|input| {
                if wall { format!("{input}\n{}", input.wall_line()) } else { input.to_string() }
            }),
            Self::LammpsConstant | Self::LiggghtsConstant => return self.constant(args, pair, end),
            Self::Mercury => Ok(MercuryDpm::new(pair).to_string()),
            Self::Esys => {
                let poisson = args
                    .bodies
                    .poisson()
                    .ok_or_else(|| CliError::usage("ESyS-Particle wants Poisson's ratio: give --poisson"))?;
                EsysParticle::new(pair, poisson).map(|input| input.to_string())
            }
            Self::Yade => {
                let velocities = args.velocities();
                let [vn] = velocities.as_slice() else {
                    return Err(CliError::usage(
                        "YADE wants the velocity vn at which it is told the coefficient: give one --velocity",
                    ));
                };
                Yade::new(pair, vn.to_f64()).map(|input| input.to_string())
            }
        };
        Ok(text.map_err(CliError::usage)? + "\n")
    }

    /// The end of contact: the one asked for, if the code has it, or the code's default.
    fn end(self, asked: Option<EndOfContact>) -> Result<End, CliError> {
        let only = |code, only: End| match asked.map(end_of) {
            Some(end) if end != only => Err(CliError::usage(MaterialError::EndNotOffered { code, end })),
            _ => Ok(only),
        };
        match self {
            Self::Lammps | Self::Liggghts | Self::LammpsConstant | Self::LiggghtsConstant => {
                Ok(end_of(asked.unwrap_or_default()))
            }
            Self::LammpsHertzHistory => only("gran/hertz/history", End::ZeroCompression),
            Self::Yade => only("YADE", End::ZeroForce),
            Self::Mercury => only("MercuryDPM", End::ZeroForce),
            Self::Esys => only("ESyS-Particle", End::ZeroForce),
        }
    }

    /// The keys of its input, as the code calls them; those in brackets may be left out.
    fn keys(self) -> &'static [&'static str] {
        match self {
            Self::Lammps => &["k_n", "eta_n0", "E", "nu", "limit_damping", "coeff_restitution", "tsuji"],
            Self::LammpsConstant => &["coeff_restitution", "tsuji"],
            Self::LiggghtsConstant => &["coefficientRestitution"],
            Self::LammpsHertzHistory => &["Kn", "gamma_n"],
            Self::Liggghts => &["kn", "gamman", "limitForce", "coefficientRestitution"],
            Self::Yade => &["en", "vn", "young", "poisson", "betan"],
            Self::Mercury => &["effectiveElasticModulus", "dissipation"],
            Self::Esys => &["A", "E", "nu"],
        }
    }
}

/// The input of a code, as typed.
pub(super) struct CodeInput {
    code: Code,
    values: Vec<(String, String)>,
}

impl CodeInput {
    /// Reads `k_n=1e7,eta_n0=2e7,limit_damping`.
    pub(super) fn parse(code: Code, text: &str) -> Result<Self, CliError> {
        let mut values: Vec<(String, String)> = Vec::new();
        for part in text.split(',') {
            let (key, value) = part.split_once('=').unwrap_or((part, "on"));
            let (key, value) = (key.trim().to_owned(), value.trim().to_owned());
            if !code.keys().contains(&key.as_str()) {
                let known = code.keys().join(", ");
                return Err(CliError::usage(format!(
                    "'{key}' is no input of this code: give KEY=VALUE with keys of {known}"
                )));
            }
            if values.iter().any(|(known, _)| *known == key) {
                return Err(CliError::usage(format!("'{key}' is given twice: give it once")));
            }
            values.push((key, value));
        }
        Ok(Self { code, values })
    }

    /// The law of constant coefficient, if the input asks for one.
    pub(super) fn constant_law(&self) -> Result<Option<ConstantRestitution>, CliError> {
        let law = if self.text("betan").is_some() {
            ConstantRestitution::of_betan(self.number("betan")?)
        } else if self.text("tsuji").is_some() {
            ConstantRestitution::of_lammps_tsuji(self.number("tsuji")?)
        } else if let Some(key) =
            ["coeff_restitution", "coefficientRestitution"].into_iter().find(|key| self.text(key).is_some())
        {
            ConstantRestitution::of_epsilon(self.number(key)?)
        } else {
            return Ok(None);
        };
        if self.values.len() > 1 {
            return Err(CliError::usage("a constant coefficient needs no other value: give it alone"));
        }
        law.map(Some).map_err(CliError::usage)
    }

    /// The contact that the input means.
    pub(super) fn pair(&self, radius: f64, mass: f64) -> Result<ViscoelasticContact, CliError> {
        let pair = match self.code {
            Code::Lammps => self.lammps()?.contact(radius, mass),
            Code::LammpsHertzHistory => {
                LammpsHertzHistory { kn: self.number("Kn")?, gamma_n: self.number("gamma_n")? }
                    .contact(radius, mass)
            }
            Code::Liggghts => {
                let (kn, gamman) = (self.number("kn")?, self.number("gamman")?);
                Liggghts { kn, gamman, end: End::ZeroForce }.contact(radius, mass)
            }
            Code::Yade => self.yade()?.contact(radius, mass),
            Code::LammpsConstant | Code::LiggghtsConstant => {
                return Err(CliError::usage("a constant coefficient is all that this input holds: give it"));
            }
            Code::Mercury => MercuryDpm {
                effective_elastic_modulus: self.number("effectiveElasticModulus")?,
                dissipation: self.number("dissipation")?,
            }
            .contact(radius, mass),
            Code::Esys => {
                let (a, young, poisson) = (self.number("A")?, self.number("E")?, self.number("nu")?);
                EsysParticle { a, young, poisson }.contact(radius, mass)
            }
        };
        pair.map_err(CliError::usage)
    }

    /// Where the code ends the contact with this input.
    pub(super) fn end(&self, asked: Option<EndOfContact>) -> Result<End, CliError> {
        let limited = match (self.code, self.text("limit_damping").or(self.text("limitForce"))) {
            (Code::Lammps | Code::Liggghts, None | Some("off")) => EndOfContact::ZeroCompression,
            (Code::Lammps | Code::Liggghts, Some("on")) => EndOfContact::ZeroForce,
            (Code::Lammps | Code::Liggghts, Some(other)) => {
                return Err(CliError::usage(format!("'{other}' is neither on nor off: give one of them")));
            }
            _ => return self.code.end(asked),
        };
        match asked {
            Some(asked) if asked != limited => Err(CliError::usage(
                "the input says where the contact ends, and --end says otherwise: leave --end out",
            )),
            _ => Ok(end_of(limited)),
        }
    }

    fn lammps(&self) -> Result<LammpsGranular, CliError> {
        let (eta_n0, end) = (self.number("eta_n0")?, End::ZeroCompression); // the end does not change A
        if self.text("k_n").is_some() {
            return Ok(LammpsGranular { k_n: self.number("k_n")?, eta_n0, end });
        }
        LammpsGranular::of_material(self.number("E")?, self.number("nu")?, eta_n0, end)
            .map_err(CliError::usage)
    }

    fn yade(&self) -> Result<Yade, CliError> {
        let vn = Quantity::parse(self.required("vn")?, Dimension::Velocity).map_err(CliError::usage)?;
        Yade::of_material(self.number("en")?, vn.to_f64(), self.number("young")?, self.number("poisson")?)
            .map_err(CliError::usage)
    }

    fn text(&self, key: &str) -> Option<&str> {
        self.values.iter().find(|(known, _)| known == key).map(|(_, value)| value.as_str())
    }

    fn required(&self, key: &str) -> Result<&str, CliError> {
        self.text(key).ok_or_else(|| {
            let known = self.code.keys().join(", ");
            CliError::usage(format!("the input has no {key}: give KEY=VALUE with keys of {known}"))
        })
    }

    fn number(&self, key: &str) -> Result<f64, CliError> {
        let number: Result<Exact, _> = self.required(key)?.parse();
        number.map(|number| number.to_f64()).map_err(|error| CliError::usage(format!("{key}: {error}")))
    }
}
