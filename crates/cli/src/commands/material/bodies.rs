//! The two bodies of a contact.

use crate::CliError;
use crate::exact::Exact;
use crate::units::{self, Quantity};
use restitution::{Contact, Material, Plane, Sphere, effective, sphere_mass};

/// What the sphere meets.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub(in crate::commands) enum Against {
    /// Another sphere.
    #[default]
    Sphere,
    /// A plane of the second material, or of the same.
    Plane,
    /// A plane that does not deform.
    RigidPlane,
}

/// Arguments that say what collides.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Bodies")]
pub(in crate::commands) struct BodyArgs {
    /// Young's modulus, such as 9.4GPa
    #[arg(long, value_name = "Y", value_parser = units::modulus, allow_hyphen_values = true)]
    young: Option<Quantity>,
    /// Poisson's ratio
    #[arg(long, value_name = "NU", allow_hyphen_values = true)]
    poisson: Option<Exact>,
    /// Mass density, such as 917kg/m3
    #[arg(long, value_name = "DENSITY", value_parser = units::density, allow_hyphen_values = true)]
    density: Option<Quantity>,
    /// Radius of the sphere, such as 2.75cm
    #[arg(long, value_name = "R", value_parser = units::length, allow_hyphen_values = true)]
    radius: Option<Quantity>,
    /// What it meets
    #[arg(long, value_enum, default_value_t, value_name = "BODY")]
    against: Against,
    /// Radius of the second sphere [default: that of the first]
    #[arg(long, value_name = "R", value_parser = units::length, allow_hyphen_values = true)]
    radius2: Option<Quantity>,
    /// Young's modulus of the second body [default: that of the first]
    #[arg(long, value_name = "Y", value_parser = units::modulus, allow_hyphen_values = true)]
    young2: Option<Quantity>,
    /// Poisson's ratio of the second body
    #[arg(long, value_name = "NU", allow_hyphen_values = true)]
    poisson2: Option<Exact>,
    /// Mass density of the second body
    #[arg(long, value_name = "DENSITY", value_parser = units::density, allow_hyphen_values = true)]
    density2: Option<Quantity>,
    /// Effective radius R1 R2/(R1 + R2), instead of the bodies
    #[arg(long, value_name = "R", value_parser = units::length, allow_hyphen_values = true, requires = "effective_mass", conflicts_with_all = ["radius", "radius2", "density", "density2", "against"])]
    effective_radius: Option<Quantity>,
    /// Effective mass m1 m2/(m1 + m2), instead of the bodies
    #[arg(long, value_name = "M", value_parser = units::mass, allow_hyphen_values = true, requires = "effective_radius")]
    effective_mass: Option<Quantity>,
    /// Effective modulus, 1/E the sum of (1 - NU^2)/Y, instead of the materials
    #[arg(long, value_name = "E", value_parser = units::modulus, allow_hyphen_values = true, requires = "effective_radius", conflicts_with_all = ["young", "poisson", "young2", "poisson2"])]
    effective_modulus: Option<Quantity>,
}

impl BodyArgs {
    /// Refuses what the second body cannot have.
    pub(in crate::commands) fn check(&self) -> Result<(), CliError> {
        if self.against != Against::Sphere && self.radius2.is_some() {
            return Err(CliError::usage("a plane has no radius: leave --radius2 out"));
        }
        let second = self.young2.is_some() || self.poisson2.is_some() || self.density2.is_some();
        if self.against == Against::RigidPlane && second {
            return Err(CliError::usage(
                "a rigid plane has no material: leave --young2, --poisson2, --density2 out",
            ));
        }
        Ok(())
    }

    /// Names everything that is missing at once.
    fn complete(&self) -> Result<(), CliError> {
        let mut missing = Vec::new();
        let mut need = |known: bool, name: &'static str| {
            if !known {
                missing.push(name);
            }
        };
        need(self.young.is_some(), "--young");
        need(self.poisson.is_some(), "--poisson");
        need(self.density.is_some(), "--density");
        need(self.radius.is_some(), "--radius");
        if self.against != Against::RigidPlane
            && (self.young2.is_some() || self.poisson2.is_some() || self.density2.is_some())
        {
            need(self.young2.is_some(), "--young2");
            need(self.poisson2.is_some(), "--poisson2");
            need(self.density2.is_some(), "--density2");
        }
        if missing.is_empty() { Ok(()) } else { Err(incomplete(&missing)) }
    }

    /// For which contacts a line of a code holds, in words.
    pub(super) fn scope(&self) -> String {
        let radius = self.radius.as_ref().map(ToString::to_string);
        match (self.against, radius) {
            (_, None) => "any two bodies of this effective radius and mass".to_owned(),
            (Against::Sphere, Some(radius)) => {
                let second = self.young2.is_some() || self.density2.is_some();
                match &self.radius2 {
                    Some(other) => format!("spheres of radius {radius} against spheres of radius {other}"),
                    None if second => {
                        format!("spheres of radius {radius} against such of the second material")
                    }
                    None => format!("spheres of radius {radius} among themselves"),
                }
            }
            (Against::Plane, Some(radius)) => format!("spheres of radius {radius} against a plane"),
            (Against::RigidPlane, Some(radius)) => {
                format!("spheres of radius {radius} against a rigid plane")
            }
        }
    }

    /// Whether anything was given.
    pub(in crate::commands) fn is_given(&self) -> bool {
        let quantities =
            [&self.young, &self.density, &self.radius, &self.radius2, &self.young2, &self.density2];
        let effective = [&self.effective_radius, &self.effective_mass, &self.effective_modulus];
        let ratios = [&self.poisson, &self.poisson2];
        quantities.into_iter().chain(effective).any(Option::is_some)
            || ratios.into_iter().any(Option::is_some)
    }

    /// Whether elastic constants were given.
    pub(super) fn is_elastic(&self) -> bool {
        self.young.is_some() || self.effective_modulus.is_some()
    }

    /// Whether the second body is a plane.
    pub(super) fn is_plane(&self) -> bool {
        self.against != Against::Sphere
    }

    /// Whether any quantity was given with a unit.
    pub(super) fn has_units(&self) -> bool {
        let all = [&self.young, &self.density, &self.radius, &self.radius2, &self.young2, &self.density2];
        let effective = [&self.effective_radius, &self.effective_mass, &self.effective_modulus];
        all.into_iter().chain(effective).flatten().any(|quantity| quantity.unit().is_some())
    }

    /// The elastic contact.
    pub(super) fn contact(&self) -> Result<Contact, CliError> {
        if let (Some(radius), Some(mass)) = (&self.effective_radius, &self.effective_mass) {
            let (radius, mass) = (radius.to_f64(), mass.to_f64());
            let contact = match &self.effective_modulus {
                Some(modulus) => Contact::new(radius, mass, modulus.to_f64()),
                None => {
                    let young = required(&self.young, "--effective-modulus or --young")?.to_f64();
                    let poisson = required(&self.poisson, "--poisson")?.to_f64();
                    Contact::of_one_material(radius, mass, young, poisson)
                }
            };
            return contact.map_err(CliError::usage);
        }
        self.complete()?;
        let sphere = self.sphere()?;
        match self.against {
            Against::Sphere => Contact::of_spheres(&sphere, &self.second_sphere(&sphere)?),
            Against::Plane => {
                Contact::with_plane(&sphere, Plane::Of(self.second_material()?.unwrap_or(*sphere.material())))
            }
            Against::RigidPlane => Contact::with_plane(&sphere, Plane::Rigid),
        }
        .map_err(CliError::usage)
    }

    /// The effective radius and mass alone, for the input of a code, which brings the modulus.
    pub(in crate::commands) fn radius_and_mass(&self) -> Result<(f64, f64), CliError> {
        if let (Some(radius), Some(mass)) = (&self.effective_radius, &self.effective_mass) {
            return Ok((radius.to_f64(), mass.to_f64()));
        }
        let radius = required(&self.radius, "--radius")?.to_f64();
        let density = required(&self.density, "--density")?.to_f64();
        let mass = sphere_mass(radius, density);
        if self.against != Against::Sphere {
            return Ok((radius, mass));
        }
        let radius2 = self.radius2.as_ref().map_or(radius, Quantity::to_f64);
        let density2 = self.density2.as_ref().map_or(density, Quantity::to_f64);
        Ok((effective(radius, radius2), effective(mass, sphere_mass(radius2, density2))))
    }

    /// The material, if it was given in full: of two, the one with the lower speed of sound.
    pub(super) fn softer_material(&self) -> Result<Option<Material>, CliError> {
        if self.young.is_none() || self.poisson.is_none() || self.density.is_none() {
            return Ok(None);
        }
        let first = self.material()?;
        let second = self.second_material()?.unwrap_or(first);
        Ok(Some(if second.sound_speed() < first.sound_speed() { second } else { first }))
    }

    /// The time that a Rayleigh wave takes around a sphere, the shorter of both; `None` if they are not given in full.
    pub(super) fn rayleigh_time(&self) -> Result<Option<f64>, CliError> {
        if [&self.young, &self.density, &self.radius].iter().any(|given| given.is_none())
            || self.poisson.is_none()
        {
            return Ok(None);
        }
        let first = self.sphere()?;
        Ok(Some(match self.against {
            Against::Sphere => first.rayleigh_time().min(self.second_sphere(&first)?.rayleigh_time()),
            _ => first.rayleigh_time(),
        }))
    }

    /// The first material.
    pub(super) fn material(&self) -> Result<Material, CliError> {
        let young = required(&self.young, "--young")?.to_f64();
        let poisson = required(&self.poisson, "--poisson")?.to_f64();
        let density = required(&self.density, "--density")?.to_f64();
        Material::new(young, poisson, density).map_err(CliError::usage)
    }

    /// The second material, if it differs from the first.
    pub(super) fn second_material(&self) -> Result<Option<Material>, CliError> {
        if self.young2.is_none() && self.poisson2.is_none() && self.density2.is_none() {
            return Ok(None);
        }
        let first = self.material()?;
        let young = self.young2.as_ref().map_or(first.young(), Quantity::to_f64);
        let poisson = self.poisson2.as_ref().map_or(first.poisson(), Exact::to_f64);
        let density = self.density2.as_ref().map_or(first.density(), Quantity::to_f64);
        Material::new(young, poisson, density).map(Some).map_err(CliError::usage)
    }

    /// The materials of both bodies, the second if it differs from the first; `None` if the contact is given as a whole, or one body is rigid.
    pub(super) fn two_materials(&self) -> Result<Option<(Material, Option<Material>)>, CliError> {
        if self.young.is_none() || self.effective_radius.is_some() || self.against == Against::RigidPlane {
            return Ok(None);
        }
        Ok(Some((self.material()?, self.second_material()?)))
    }

    /// The contacts of spheres of the first kind and of the second among themselves, if the kinds differ.
    pub(super) fn unlike_contacts(&self, met: &Contact) -> Result<Option<[Contact; 2]>, CliError> {
        let (Against::Sphere, Some(radius), Some(density)) = (self.against, &self.radius, &self.density)
        else {
            return Ok(None);
        };
        let (radius, density) = (radius.to_f64(), density.to_f64());
        let radius2 = self.radius2.as_ref().map_or(radius, Quantity::to_f64);
        let density2 = self.density2.as_ref().map_or(density, Quantity::to_f64);
        if radius2 == radius && self.second_material()?.is_none() {
            return Ok(None);
        }
        let moduli = match (self.has_two_materials(), self.second_material()?) {
            (true, Some(second)) => [self.material()?, second].map(|material| material.effective_modulus()),
            _ => [met.effective_modulus(); 2],
        };
        let alike = |radius: f64, density: f64, modulus: f64| {
            Contact::of_equal_spheres(radius, density, modulus).map_err(CliError::usage)
        };
        Ok(Some([alike(radius, density, moduli[0])?, alike(radius2, density2, moduli[1])?]))
    }

    /// Whether the second body deforms and is of another material.
    pub(super) fn has_two_materials(&self) -> bool {
        self.against != Against::RigidPlane && (self.young2.is_some() || self.poisson2.is_some())
    }

    /// Poisson's ratio, if it was given.
    pub(super) fn poisson(&self) -> Option<f64> {
        self.poisson.as_ref().map(Exact::to_f64)
    }

    fn sphere(&self) -> Result<Sphere, CliError> {
        let radius = required(&self.radius, "--radius")?.to_f64();
        Sphere::new(self.material()?, radius).map_err(CliError::usage)
    }

    fn second_sphere(&self, first: &Sphere) -> Result<Sphere, CliError> {
        let material = self.second_material()?.unwrap_or(*first.material());
        let radius = self.radius2.as_ref().map_or(first.radius(), Quantity::to_f64);
        Sphere::new(material, radius).map_err(CliError::usage)
    }
}

/// What to say of arguments that are missing, of which there is one at least.
pub(in crate::commands) fn incomplete(missing: &[&str]) -> CliError {
    let names = match missing {
        [rest @ .., last] if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
        _ => missing.concat(),
    };
    CliError::usage(format!("the bodies are not complete: give {names}"))
}

fn required<'a, T>(value: &'a Option<T>, name: &str) -> Result<&'a T, CliError> {
    value.as_ref().ok_or_else(|| incomplete(&[name]))
}
