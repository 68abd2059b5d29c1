//! The lines of codes that make the coefficient the same at every velocity.

use super::request::{Dissipation, Request};
use crate::CliError;
use restitution::codes::{ConstantCode, ConstantRestitution};
use restitution::{Contact, End};

/// The law that rebounds as measured.
pub(super) fn law(request: &Request, end: End) -> Result<ConstantRestitution, CliError> {
    let Dissipation::Given(args) = &request.dissipation else {
        return Err(not_measured());
    };
    let measured = args.measured()?.ok_or_else(not_measured)?;
    ConstantRestitution::that_gives(1.0 - measured.lost, end).map_err(CliError::usage)
}

fn not_measured() -> CliError {
    CliError::usage(
        "a constant coefficient is one that was measured: give --measured, --heights, --speeds or --bounce-times",
    )
}

/// Young's modulus and Poisson's ratio of a body.
#[derive(Clone, Copy)]
struct Elastic(f64, f64);

/// The lines for one code.
pub(super) fn lines(
    code: ConstantCode,
    request: &Request,
    law: &ConstantRestitution,
    contact: &Contact,
    end: End,
) -> Result<String, CliError> {
    let told = code.input(law).map_err(CliError::usage)?;
    let told = format!("{told:.9}");
    let told = told.trim_end_matches('0');
    let (wall, limited) = (request.bodies.is_plane(), end == End::ZeroForce);
    if code == ConstantCode::Lammps {
        return Ok(lammps(told, contact, wall, limited));
    }
    if code == ConstantCode::Yade {
        return Ok(format!("Ip2_FrictMat_FrictMat_MindlinPhys(betan={told})\n"));
    }
    let (one, other) = materials(request, contact, code)?;
    Ok(match code {
        ConstantCode::Liggghts => liggghts(told, one, other, wall, limited),
        ConstantCode::Chrono => chrono(told, one, wall, contact),
        ConstantCode::DemEngine => dem_engine(told, one, other),
        ConstantCode::Lethe => lethe(told, one, other, wall),
        ConstantCode::Mfix => mfix(told, one, other, wall),
        ConstantCode::Kratos => kratos(told, one, other),
        _ => trixi_particles(told, one),
    })
}

/// The materials of both bodies; those of two equal bodies that make the contact, if the bodies are not given one by one.
fn materials(
    request: &Request,
    contact: &Contact,
    code: ConstantCode,
) -> Result<(Elastic, Option<Elastic>), CliError> {
    let material = |material: restitution::Material| Elastic(material.young(), material.poisson());
    if let Some((one, other)) = request.bodies.two_materials()? {
        return Ok((material(one), other.map(material)));
    }
    let poisson = request
        .bodies
        .poisson()
        .ok_or_else(|| CliError::usage(format!("{} wants Poisson's ratio: give --poisson", code.name())))?;
    let young = 2.0 * contact.effective_modulus() * (1.0 - poisson) * (1.0 + poisson);
    Ok((Elastic(young, poisson), None))
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

fn liggghts(told: &str, one: Elastic, other: Option<Elastic>, wall: bool, limited: bool) -> String {
    let limit = if limited { "on" } else { "off" };
    let model = "model hertz tangential no_history";
    let types = [Some(one), other].into_iter().flatten().collect::<Vec<_>>();
    let each =
        |value: fn(&Elastic) -> f64| types.iter().map(|e| number(value(e))).collect::<Vec<_>>().join(" ");
    let hard = if types.iter().any(|e| e.0 > 1e9) { "hard_particles yes\n" } else { "" }; // else refused
    let pairs = |value: &str| {
        let values = vec![value; types.len() * types.len()].join(" ");
        format!("peratomtypepair {} {values}", types.len())
    };
    let mut lines = format!("{hard}pair_style gran {model} limitForce {limit}\npair_coeff * *\n");
    lines += &format!("fix young all property/global youngsModulus peratomtype {}\n", each(|e| e.0));
    lines += &format!("fix poisson all property/global poissonsRatio peratomtype {}\n", each(|e| e.1));
    lines += &format!("fix cor all property/global coefficientRestitution {}\n", pairs(told));
    lines += &format!("fix friction all property/global coefficientFriction {}\n", pairs("0"));
    if wall {
        let kind = types.len();
        lines +=
            &format!("fix wall all wall/gran {model} primitive type {kind} zplane 0.0 limitForce {limit}\n");
    }
    lines
}

fn chrono(told: &str, one: Elastic, wall: bool, contact: &Contact) -> String {
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
        number(one.0),
        number(one.1)
    );
    lines
}

fn dem_engine(told: &str, one: Elastic, other: Option<Elastic>) -> String {
    let load = |name: &str, Elastic(young, poisson): Elastic| {
        format!(
            "auto {name} = solver.LoadMaterial({{{{\"E\", {}}}, {{\"nu\", {}}}, {{\"CoR\", {told}}}}});\n",
            number(young),
            number(poisson)
        )
    };
    let mut lines = "solver.UseFrictionlessHertzianModel();\n".to_owned() + &load("material", one);
    if let Some(other) = other {
        lines += &load("other", other);
        lines += &format!("solver.SetMaterialPropertyPair(\"CoR\", material, other, {told});\n");
    }
    lines
}

fn lethe(told: &str, one: Elastic, other: Option<Elastic>, wall: bool) -> String {
    let body = |Elastic(young, poisson): Elastic, indent: &str, what: &str| {
        format!(
            "{indent}set young modulus {what} = {}\n{indent}set poisson ratio {what} = {}\n{indent}set restitution coefficient {what} = {told}\n",
            number(young),
            number(poisson)
        )
    };
    let particle = |number: usize, elastic| {
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

fn mfix(told: &str, one: Elastic, other: Option<Elastic>, wall: bool) -> String {
    let mut lines = "DES_COLL_MODEL = 'HERTZIAN'\n".to_owned();
    let phase =
        |k: usize, e: Elastic| format!("E_YOUNG({k}) = {}\nV_POISSON({k}) = {}\n", number(e.0), number(e.1));
    lines += &phase(1, one);
    if wall {
        let Elastic(young, poisson) = other.unwrap_or(one);
        lines += &format!("Ew_YOUNG = {}\nVw_POISSON = {}\n", number(young), number(poisson));
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

fn kratos(told: &str, one: Elastic, other: Option<Elastic>) -> String {
    let body = |Elastic(young, poisson): Elastic| {
        format!("\"YOUNG_MODULUS\": {}, \"POISSON_RATIO\": {}\n", number(young), number(poisson))
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

fn trixi_particles(told: &str, one: Elastic) -> String {
    format!(
        "# a negative coefficient damps: the source (0.5) adds it along the relative velocity\nDEMSystem(initial_condition; contact_model=HertzContactModel({}, {}), damping_coefficient={told})\n",
        number(one.0),
        number(one.1)
    )
}
