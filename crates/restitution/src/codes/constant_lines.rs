//! The lines of codes that make the coefficient the same at every velocity.

use super::{ConstantCode, ConstantRestitution};
use crate::{Contact, End, MaterialError};
use std::borrow::ToOwned;
use std::format;
use std::string::String;
use std::vec;
use std::vec::Vec;

/// Young's modulus and Poisson's ratio of a body, as input files are told them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elastic {
    /// Young's modulus, in Pa.
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
}

impl Elastic {
    /// The constants of two equal bodies that make the contact, for a Poisson ratio: `Y = 2 E (1 - nu^2)`.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution::Contact;
    /// use restitution::codes::Elastic;
    ///
    /// let contact = Contact::new(0.01, 0.1, 1e9)?;
    /// assert_eq!(Elastic::of_equal_bodies(&contact, 0.5)?.young, 1.5e9);
    ///
    /// assert!(Elastic::of_equal_bodies(&contact, 0.7).is_err());
    /// # Ok::<(), restitution::MaterialError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`MaterialError::PoissonRatio`] outside (-1, 1/2].
    pub fn of_equal_bodies(contact: &Contact, poisson: f64) -> Result<Self, MaterialError> {
        Ok(Self { young: 2.0 * contact.effective_modulus() * super::plane_strain(poisson)?, poisson })
    }
}

/// The bodies that an input with a constant coefficient is for.
#[derive(Clone, Copy, Debug)]
pub struct ConstantBodies {
    /// Their contact.
    pub contact: Contact,
    /// The material of the first body, and of the second if it differs; only the codes that
    /// [name materials](ConstantCode::names_materials) need them.
    pub materials: Option<(Elastic, Option<Elastic>)>,
    /// Whether the second body is a plane.
    pub is_plane: bool,
}

impl ConstantCode {
    /// Whether the lines name Young's modulus and Poisson's ratio.
    pub fn names_materials(self) -> bool {
        !matches!(self, Self::Lammps | Self::Yade)
    }

    /// Returns the lines of the code's input with which the bodies rebound as `law` says.
    ///
    /// # Errors
    ///
    /// [`MaterialError::EpsilonNotOffered`] for a coefficient that no input makes, [`MaterialError::MaterialsMissing`].
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution::codes::{ConstantBodies, ConstantCode, ConstantRestitution, Elastic};
    /// use restitution::{Contact, End, MaterialError};
    ///
    /// let law = ConstantRestitution::of_epsilon(0.7)?;
    /// let contact = Contact::new(0.01, 0.1, 1e9)?;
    /// let bodies = ConstantBodies { contact, materials: None, is_plane: false };
    /// let lines = ConstantCode::Lammps.lines(&law, End::ZeroCompression, &bodies)?;
    /// assert!(lines.ends_with("damping coeff_restitution\n"));
    ///
    /// let lethe = ConstantCode::Lethe.lines(&law, End::ZeroCompression, &bodies);
    /// assert_eq!(lethe, Err(MaterialError::MaterialsMissing { code: "Lethe" }));
    /// # Ok::<(), MaterialError>(())
    /// ```
    pub fn lines(
        self,
        law: &ConstantRestitution,
        end: End,
        bodies: &ConstantBodies,
    ) -> Result<String, MaterialError> {
        let told = format!("{:.9}", self.input(law)?);
        let told = told.trim_end_matches('0');
        let (wall, limited, contact) = (bodies.is_plane, end == End::ZeroForce, &bodies.contact);
        match self {
            Self::Lammps => return Ok(lammps(told, contact, wall, limited)),
            Self::Yade => return Ok(format!("Ip2_FrictMat_FrictMat_MindlinPhys(betan={told})\n")),
            _ => {}
        }
        let missing = MaterialError::MaterialsMissing { code: self.name() };
        let (one, other) = bodies.materials.as_ref().ok_or(missing)?;
        let other = other.as_ref();
        Ok(match self {
            Self::Liggghts => liggghts(told, one, other, wall, limited),
            Self::Chrono => chrono(told, one, wall, contact),
            Self::DemEngine => dem_engine(told, one, other),
            Self::Lethe => lethe(told, one, other, wall),
            Self::Mfix => mfix(told, one, other, wall),
            Self::Kratos => kratos(told, one, other),
            _ => trixi_particles(told, one),
        })
    }
}

/// A number as input files take it, without the last digits, which are rounding.
fn number(value: f64) -> String {
    let value = format!("{value:.14e}").parse().unwrap_or(value);
    if value == 0.0 || (1e-3..1e6).contains(&f64::abs(value)) {
        format!("{value:?}")
    } else {
        format!("{value:e}")
    }
}

fn lammps(told: &str, contact: &Contact, wall: bool, limited: bool) -> String {
    let limit = if limited { " limit_damping" } else { "" };
    let k_n = 4.0 / 3.0 * contact.effective_modulus();
    let model =
        format!("hertz {k_n:e} {told} tangential linear_nohistory 0 0 damping coeff_restitution{limit}");
    match wall {
        true => format!("fix wall all wall/gran granular {model} zplane 0.0 NULL\n"),
        false => format!("pair_style granular\npair_coeff * * {model}\n"),
    }
}

fn liggghts(told: &str, one: &Elastic, other: Option<&Elastic>, wall: bool, limited: bool) -> String {
    let limit = if limited { "on" } else { "off" };
    let model = "model hertz tangential no_history";
    let types = [Some(one), other].into_iter().flatten().collect::<Vec<_>>();
    let each =
        |value: fn(&Elastic) -> f64| types.iter().map(|e| number(value(e))).collect::<Vec<_>>().join(" ");
    let hard = if types.iter().any(|e| e.young > 1e9) { "hard_particles yes\n" } else { "" }; // else refused
    let pairs = |value: &str| {
        let values = vec![value; types.len() * types.len()].join(" ");
        format!("peratomtypepair {} {values}", types.len())
    };
    let mut lines = format!("{hard}pair_style gran {model} limitForce {limit}\npair_coeff * *\n");
    lines += &format!("fix young all property/global youngsModulus peratomtype {}\n", each(|e| e.young));
    lines += &format!("fix poisson all property/global poissonsRatio peratomtype {}\n", each(|e| e.poisson));
    lines += &format!("fix cor all property/global coefficientRestitution {}\n", pairs(told));
    lines += &format!("fix friction all property/global coefficientFriction {}\n", pairs("0"));
    if wall {
        let kind = types.len();
        lines +=
            &format!("fix wall all wall/gran {model} primitive type {kind} zplane 0.0 limitForce {limit}\n");
    }
    lines
}

fn chrono(told: &str, one: &Elastic, wall: bool, contact: &Contact) -> String {
    let mut lines = String::new();
    if wall {
        let radius = contact.effective_radius();
        lines += &format!(
            "ChCollisionInfo::SetDefaultEffectiveCurvatureRadius({radius:?});  // Chrono has 0.1 m for a plane\n"
        );
    }
    lines += "system.UseMaterialProperties(true);\nsystem.SetContactForceModel(ChSystemSMC::Hertz);\n";
    lines += &format!(
        "material->SetYoungModulus({});\nmaterial->SetPoissonRatio({});\nmaterial->SetRestitution({told});\n",
        number(one.young),
        number(one.poisson)
    );
    lines
}

fn dem_engine(told: &str, one: &Elastic, other: Option<&Elastic>) -> String {
    let load = |name: &str, Elastic { young, poisson }: &Elastic| {
        format!(
            "auto {name} = solver.LoadMaterial({{{{\"E\", {}}}, {{\"nu\", {}}}, {{\"CoR\", {told}}}}});\n",
            number(*young),
            number(*poisson)
        )
    };
    let mut lines = "solver.UseFrictionlessHertzianModel();\n".to_owned() + &load("material", one);
    if let Some(other) = other {
        lines += &load("other", other);
        lines += &format!("solver.SetMaterialPropertyPair(\"CoR\", material, other, {told});\n");
    }
    lines
}

fn lethe(told: &str, one: &Elastic, other: Option<&Elastic>, wall: bool) -> String {
    let body = |Elastic { young, poisson }: &Elastic, indent: &str, what: &str| {
        format!(
            "{indent}set young modulus {what} = {}\n{indent}set poisson ratio {what} = {}\n{indent}set restitution coefficient {what} = {told}\n",
            number(*young),
            number(*poisson)
        )
    };
    let particle = |number: usize, elastic: &Elastic| {
        format!("  subsection particle type {number}\n{}  end\n", body(elastic, "    ", "particles"))
    };
    let mut lines = "subsection lagrangian physical properties\n".to_owned() + &particle(0, one);
    match (wall, other) {
        (true, other) => lines += &body(other.unwrap_or(one), "  ", "wall"),
        (false, Some(other)) => lines += &particle(1, other),
        (false, None) => {}
    }
    let kind = if wall { "wall" } else { "particle" };
    lines += &format!("end\nsubsection model parameters\n  set particle {kind} contact force method = ");
    lines + if wall { "nonlinear" } else { "hertz_mindlin_limit_overlap" } + "\nend\n"
}

fn mfix(told: &str, one: &Elastic, other: Option<&Elastic>, wall: bool) -> String {
    let mut lines = "DES_COLL_MODEL = 'HERTZIAN'\n".to_owned();
    let phase = |k: usize, e: &Elastic| {
        format!("E_YOUNG({k}) = {}\nV_POISSON({k}) = {}\n", number(e.young), number(e.poisson))
    };
    lines += &phase(1, one);
    if wall {
        let Elastic { young, poisson } = other.unwrap_or(one);
        lines += &format!("Ew_YOUNG = {}\nVw_POISSON = {}\n", number(*young), number(*poisson));
        return lines + &format!("DES_EN_WALL_INPUT(1) = {told}\nDES_ET_WALL_INPUT(1) = 1.0\n");
    }
    let inputs = if let Some(other) = other {
        lines += &phase(2, other);
        3 // 1 1, 1 2, 2 2
    } else {
        1
    };
    for k in 1..=inputs {
        lines += &format!("DES_EN_INPUT({k}) = {told}\nDES_ET_INPUT({k}) = 1.0\n");
    }
    lines
}

fn kratos(told: &str, one: &Elastic, other: Option<&Elastic>) -> String {
    let body = |Elastic { young, poisson }: &Elastic| {
        format!("\"YOUNG_MODULUS\": {}, \"POISSON_RATIO\": {}\n", number(*young), number(*poisson))
    };
    let mut lines =
        "// in \"Variables\" of the material, then of the second, if there is one, then of their relation\n"
            .to_owned()
            + &body(one);
    lines += &other.map(body).unwrap_or_default();
    lines
        + &format!(
            "\"COEFFICIENT_OF_RESTITUTION\": {told}, \"DEM_DISCONTINUUM_CONSTITUTIVE_LAW_NAME\": \"DEM_D_Hertz_viscous_Coulomb\"\n"
        )
}

fn trixi_particles(told: &str, one: &Elastic) -> String {
    format!(
        "# a negative coefficient damps: the source (0.5) adds it along the relative velocity\nDEMSystem(initial_condition; contact_model=HertzContactModel({}, {}), damping_coefficient={told})\n",
        number(one.young),
        number(one.poisson)
    )
}
