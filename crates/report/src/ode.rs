//! Direct integration with an ODE library, as one would do it without this project.

use differential_equations::prelude::*;

/// The scaled collision of spheres, `x'' + u sqrt(x) x' + x^(3/2) = 0`, with state `(x, x')`.
struct Contact {
    u: f64,
}

impl ODE<f64, [f64; 2]> for Contact {
    fn diff(&self, _t: f64, y: &[f64; 2], dydt: &mut [f64; 2]) {
        let root = y[0].max(0.0).sqrt();
        *dydt = [y[1], -root * (y[0] + self.u * y[1])];
    }
}

impl Event<f64, [f64; 2]> for Contact {
    fn config(&self) -> EventConfig {
        EventConfig::default().direction(CrossingDirection::Negative).terminal()
    }

    fn event(&self, _t: f64, y: &[f64; 2]) -> f64 {
        y[0]
    }
}

/// Methods of Dormand and Prince with step control and dense output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Order 5(4).
    Dopri5,
    /// Order 8(5,3).
    Dop853,
}

/// A time at which every collision of the report has long ended; those of high damping are slow.
const LONG: f64 = 1e6;

/// Returns `epsilon(u)` from the speed at zero compression; NaN if the library gives up.
pub fn epsilon(u: f64, method: Method, tolerance: f64) -> f64 {
    let contact = Contact { u };
    let problem = IVP::ode(&contact, 0.0, LONG, [0.0, 1.0]).event(&contact);
    let solution = match method {
        Method::Dopri5 => problem
            .method(ExplicitRungeKutta::dopri5().rtol(tolerance).atol(tolerance).max_steps(1_000_000))
            .solve(),
        Method::Dop853 => problem
            .method(ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance).max_steps(1_000_000))
            .solve(),
    };
    match solution {
        Ok(solution) if matches!(solution.status, Status::Interrupted) => {
            solution.y.last().map_or(f64::NAN, |y| -y[1])
        }
        _ => f64::NAN,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_library_integrates_the_collision() {
        for (method, tolerance) in [(Method::Dopri5, 1e-6), (Method::Dop853, 1e-9)] {
            let error = epsilon(1.0, method, tolerance) / 0.331_164_810_466_640_9 - 1.0;
            assert!(error.abs() < 1e3 * tolerance, "{method:?}: {error:e}");
        }
    }
}
