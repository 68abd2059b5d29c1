//! The inputs of discrete-element codes, there and back.

use super::{MaterialArgs, end_of};
use crate::CliError;
use crate::args::EndOfContact;
use crate::exact::Exact;
use crate::units::{Dimension, Quantity};
use restitution::codes::{
    ConstantRestitution, EsysParticle, LammpsGranular, LammpsHertzHistory, Liggghts, MercuryDpm, Yade,
};
use restitution::{End, MaterialError, ViscoelasticContact};

/// A discrete-element code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum Code {
    /// LAMMPS, pair_style granular, hertz with damping viscoelastic.
    Lammps,
    /// LAMMPS, pair_style gran/hertz/history.
    LammpsHertzHistory,
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
        let contact = args.bodies.contact()?;
        let pair = args.damping.pair(&args.bodies, contact, end)?.ok_or_else(|| {
            CliError::usage("nothing says how the material dissipates: give --dissipative-constant, --eta1 and --eta2, --measured or --g-star")
        })?;
        self.text(args, &pair, end)
    }

    fn text(self, args: &MaterialArgs, pair: &ViscoelasticContact, end: End) -> Result<String, CliError> {
        let text = match self {
            Self::Lammps => LammpsGranular::new(pair, end).map(|input| input.to_string()),
            Self::LammpsHertzHistory => LammpsHertzHistory::new(pair).map(|input| input.to_string()),
            Self::Liggghts => Liggghts::new(pair, end).map(|input| input.to_string()),
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
            Self::Lammps | Self::Liggghts => Ok(end_of(asked.unwrap_or_default())),
            Self::LammpsHertzHistory => only("gran/hertz/history", End::ZeroCompression),
            Self::Yade => only("YADE", End::ZeroForce),
            Self::Mercury => only("MercuryDPM", End::ZeroForce),
            Self::Esys => only("ESyS-Particle", End::ZeroForce),
        }
    }

    /// The keys of its input, as the code calls them; those in brackets may be left out.
    fn keys(self) -> &'static [&'static str] {
        match self {
            Self::Lammps => &["k_n", "eta_n0", "E", "nu", "limit_damping", "e"],
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
        } else if let Some(key) =
            ["e", "coefficientRestitution"].into_iter().find(|key| self.text(key).is_some())
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
