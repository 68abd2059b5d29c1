//! What the input of a code means.

use super::Code;
use crate::CliError;
use crate::args::EndOfContact;
use crate::commands::material::end_of;
use crate::exact::Exact;
use crate::units::{Dimension, Quantity};
use restitution::codes::{
    Chrono, ConstantCode, ConstantRestitution, EsysParticle, LammpsGranular, LammpsHertzHistory, Liggghts,
    MercuryDpm, Yade,
};
use restitution::{End, ViscoelasticContact};

/// The input of a code, as typed.
pub(in crate::commands::material) struct CodeInput {
    code: Code,
    values: Vec<(String, String)>,
}

/// A law of constant coefficient and the ends at which the code may end a contact.
pub(in crate::commands::material) type Constant = (ConstantRestitution, &'static [End]);

const BOTH: &[End] = &[End::ZeroCompression, End::ZeroForce];

impl CodeInput {
    /// Reads `k_n=1e7,eta_n0=2e7,limit_damping`.
    pub(in crate::commands::material) fn parse(code: Code, text: &str) -> Result<Self, CliError> {
        if code == Code::Rebound {
            return Err(CliError::usage(
                "REBOUND takes a function, which means what it says: give --code rebound to have one",
            ));
        }
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
    pub(in crate::commands::material) fn constant_law(&self) -> Result<Option<Constant>, CliError> {
        let key = |key| self.text(key).is_some().then_some(key);
        let (law, ends) = if key("betan").is_some() {
            (ConstantRestitution::of_betan(self.number("betan")?), &[End::ZeroForce][..])
        } else if key("tsuji").is_some() {
            (ConstantRestitution::of_lammps_tsuji(self.number("tsuji")?), BOTH)
        } else if let Some(key) = key("coeff_restitution").or(key("coefficientRestitution")) {
            (ConstantCode::Lammps.law(self.number(key)?), BOTH)
        } else if let Some(code) = self.code.constant() {
            (code.law(self.number(self.code.keys()[0])?), code.ends())
        } else {
            return Ok(None);
        };
        if self.values.len() > 1 {
            return Err(CliError::usage("a constant coefficient needs no other value: give it alone"));
        }
        law.map(|law| Some((law, ends))).map_err(CliError::usage)
    }

    /// The contact that the input means.
    pub(in crate::commands::material) fn pair(
        &self,
        radius: f64,
        mass: f64,
    ) -> Result<ViscoelasticContact, CliError> {
        let number = |key| self.number(key);
        let pair = match self.code {
            Code::LammpsHertzHistory => {
                LammpsHertzHistory { kn: number("Kn")?, gamma_n: number("gamma_n")? }.contact(radius, mass)
            }
            Code::Liggghts => {
                let (kn, gamman) = (number("kn")?, number("gamman")?);
                Liggghts { kn, gamman, end: End::ZeroForce }.contact(radius, mass)
            }
            Code::Yade => self.yade()?.contact(radius, mass),
            Code::Mercury => MercuryDpm {
                effective_elastic_modulus: number("effectiveElasticModulus")?,
                dissipation: number("dissipation")?,
            }
            .contact(radius, mass),
            Code::Esys => {
                let (a, young, poisson) = (number("A")?, number("E")?, number("nu")?);
                EsysParticle { a, young, poisson }.contact(radius, mass)
            }
            Code::Chrono => Chrono { kn: number("kn")?, gn: number("gn")? }.contact(radius, mass),
            _ => self.lammps()?.contact(radius, mass),
        };
        pair.map_err(CliError::usage)
    }

    /// Where the code ends the contact with this input.
    pub(in crate::commands::material) fn end(&self, asked: Option<EndOfContact>) -> Result<End, CliError> {
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
