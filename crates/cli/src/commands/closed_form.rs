//! `restitution closed-form`: a coefficient as an expression in Beta values and iterated Beta integrals.

use crate::args::{self, LawArgs};
use crate::output::TargetArgs;
use crate::{CliError, memory, progress};
use restitution_closed::{ClosedForm, Constant, Family, LARGEST_ORDER, Language, Reduction, closed_form};
use serde_json::{Value, json};

/// What the python form needs to evaluate iterated Beta integrals.
const ITERATED_BETA: &str = include_str!("closed_form/iterated_beta.py");
/// Digits of a value that are computed and not shown, in programs.
const SPARE_DIGITS: usize = 20;

/// Arguments of `restitution closed-form`.
#[derive(Debug, clap::Args)]
pub struct ClosedFormArgs {
    /// The index k of the coefficient, up to u^12: from 1 to 12 for C and a, to 25 for h of spheres, which counts powers of sqrt(u)
    #[arg(long, value_name = "K", value_parser = order)]
    order: usize,
    /// Which coefficient: C of eps = 1 + C_1 u + ..., a of eps = 1 - a_1 s + ..., h of the zero-force end
    #[arg(long, value_enum, value_name = "QUANTITY", default_value = "a")]
    quantity: Quantity,
    /// Significant digits of the value
    #[arg(long, value_name = "D", default_value = "20", value_parser = args::digits)]
    digits: usize,
    /// The form of the expression
    #[arg(long, value_enum, value_name = "FORMAT", default_value = "text")]
    format: Form,
    /// Keep constants that an exponent of this law reduces, so that the formula is that of a law in general
    #[arg(long)]
    general: bool,
    #[command(flatten)]
    law: LawArgs,
    #[command(flatten)]
    target: TargetArgs,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Quantity {
    #[value(name = "C")]
    C,
    #[value(name = "a")]
    A,
    #[value(name = "h")]
    H,
}

impl Quantity {
    fn family(self) -> Family {
        match self {
            Self::C => Family::Restitution,
            Self::A => Family::Scaled,
            Self::H => Family::DelayedRecovery,
        }
    }

    fn meaning(self) -> &'static str {
        match self {
            Self::C => "eps(u) = 1 + C_1 u + C_2 u^2 + ...",
            Self::A => "eps = 1 - a_1 s + a_2 s^2 - ..., s = -C_1 u",
            Self::H => "eps(u) = sum_k h_k u^(k/d), contact ending at zero force",
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Form {
    Text,
    Latex,
    Json,
    Python,
    Sympy,
}

/// Reads an index; which is the largest depends on the quantity and the law.
fn order(text: &str) -> Result<usize, String> {
    args::order(text).map_err(|_| {
        format!(
            "an order is a whole number: give one from 1 to {LARGEST_ORDER} for C and a, to {} for h of spheres (up to u^{LARGEST_ORDER})",
            2 * LARGEST_ORDER + 1
        )
    })
}

impl ClosedFormArgs {
    /// Derives and prints the closed form, its value and the constants it needs.
    ///
    /// # Errors
    ///
    /// Usage beyond the orders that are derived, for a law without zero-force end and for more digits than
    /// memory holds; what the output says.
    pub fn run(&self) -> Result<(), CliError> {
        self.target.check()?;
        memory::require(restitution_closed::memory_estimate(self.digits), "lower --digits")?;
        let reduction = if self.general { Reduction::General } else { Reduction::Special };
        let text = progress::during("closed form", || {
            let form = closed_form(self.quantity.family(), &self.law.law, self.order, reduction)?;
            match self.format {
                Form::Text => self.text(&form),
                Form::Latex => self.latex(&form),
                Form::Json => self.json(&form),
                Form::Python => Ok(self.python(&form)),
                Form::Sympy => self.sympy(&form),
            }
        })?;
        self.target.write(&text)
    }

    /// The value and its radius.
    fn value(&self, form: &ClosedForm) -> Result<(String, String), CliError> {
        let unproved =
            || CliError::failure(format!("{} digits could not be proved: ask for fewer", self.digits));
        form.value(self.digits)?.to_digits_and_radius(self.digits).ok_or_else(unproved)
    }

    fn constant_digits(&self, constant: &Constant, digits: usize) -> Result<String, CliError> {
        let bits = u32::try_from(digits * 3322 / 1000 + 64).unwrap_or(u32::MAX / 2);
        let unproved = || CliError::failure(format!("{digits} digits could not be proved: ask for fewer"));
        constant.value(bits)?.to_digits(digits).ok_or_else(unproved)
    }

    fn text(&self, form: &ClosedForm) -> Result<String, CliError> {
        let (value, radius) = self.value(form)?;
        let mut lines = vec![
            format!("{} = {}", form.name(), form.expression(Language::Text)),
            format!("{} = {}", " ".repeat(form.name().len()), value),
            String::new(),
        ];
        for constant in form.constants() {
            lines.push(format!("{} = {}", constant.name(), self.constant_digits(&constant, self.digits)?));
        }
        lines.push(String::new());
        lines.extend(self.definitions(form));
        lines.push(format!("radius: the true value differs from the one shown by no more than {radius}"));
        Ok(lines.join("\n") + "\n")
    }

    fn definitions(&self, form: &ClosedForm) -> Vec<String> {
        let law = &self.law.law;
        let mut lines = vec![format!(
            "x'' + u x^({}) x' + x^({}) = 0, {}",
            law.gamma(),
            law.a(),
            self.quantity.meaning()
        )];
        let lengths = form.constants().iter().map(|c| c.exponents.len()).collect::<Vec<_>>();
        if lengths.contains(&1) {
            lines.push("B(p, 3/2) = int_0^1 z^(p-1) sqrt(1-z) dz".to_owned());
        }
        if lengths.iter().any(|&length| length > 1) {
            lines.push(
                "M(p_1, ..., p_r) = integral over -1 < v_r < ... < v_1 < 1 of the product of (1-v_i^2)^(p_i-1) v_i^2 dv_i"
                    .to_owned(),
            );
        }
        lines
    }

    fn latex(&self, form: &ClosedForm) -> Result<String, CliError> {
        let (value, _) = self.value(form)?;
        let shown = value.replace('e', " \\cdot 10^{") + if value.contains('e') { "}" } else { "" };
        let mut lines = vec![
            "% for a document of any class; no package is needed".to_owned(),
            "\\begin{eqnarray*}".to_owned(),
            format!(
                "{}_{{{}}} &=& {} \\\\",
                form.family.letter(),
                form.order,
                form.expression(Language::Latex)
            ),
            format!("&=& {shown}\\ldots"),
            "\\end{eqnarray*}".to_owned(),
        ];
        if form.constants().iter().any(|constant| constant.exponents.len() > 1) {
            lines.push(
                "with $M(p_1, \\ldots, p_r) = \\int_{-1 < v_r < \\cdots < v_1 < 1} \\prod_i (1-v_i^2)^{p_i-1} v_i^2 \\, \
                 \\mathrm{d}v_i$"
                    .to_owned(),
            );
        }
        Ok(lines.join("\n") + "\n")
    }

    fn json(&self, form: &ClosedForm) -> Result<String, CliError> {
        let (value, radius) = self.value(form)?;
        let exponents =
            |constant: &Constant| constant.exponents.iter().map(ToString::to_string).collect::<Vec<_>>();
        let constants = form.constants().into_iter().map(|constant| {
            let digits = self.constant_digits(&constant, self.digits)?;
            Ok(json!({ "name": constant.name(), "exponents": exponents(&constant), "value": digits }))
        });
        let constants = constants.collect::<Result<Vec<Value>, CliError>>()?;
        let terms = form.terms.iter().map(|term| {
            let factors = term
                .factors
                .iter()
                .map(|(constant, power)| json!({ "constant": constant.name(), "power": power }));
            json!({
                "coefficient": term.coefficient.to_string(),
                "base_power": term.base_power,
                "factors": factors.collect::<Vec<_>>(),
            })
        });
        let whole = json!({
            "quantity": form.family.letter(),
            "k": form.order,
            "law": self.law.law.to_string(),
            "s": form.s.to_string(),
            "base": { "number": form.base.number.to_string(), "exponent": form.base.exponent.to_string() },
            "expression": form.expression(Language::Text),
            "terms": terms.collect::<Vec<_>>(),
            "constants": constants,
            "definition": "M(p_1, ..., p_r) = integral over -1 < v_r < ... < v_1 < 1 of prod (1-v_i^2)^(p_i-1) v_i^2 dv_i; \
                           B(p, 3/2) = M(p)",
            "value": value,
            "radius": radius,
        });
        Ok(format!("{whole:#}\n"))
    }

    fn python(&self, form: &ClosedForm) -> String {
        let iterated = form.constants().iter().any(|constant| constant.exponents.len() > 1);
        let head = self.definitions(form).into_iter().map(|line| format!("# {line}\n")).collect::<String>();
        format!(
            "{head}from mpmath import beta, ldexp, mp, mpf, nstr\n\nmp.dps = {}\n{}\n{} = {}\nprint(nstr({}, {}))\n",
            self.digits + SPARE_DIGITS,
            if iterated { format!("{ITERATED_BETA}\n") } else { String::new() },
            form.name(),
            form.expression(Language::Python),
            form.name(),
            self.digits,
        )
    }

    fn sympy(&self, form: &ClosedForm) -> Result<String, CliError> {
        let iterated: Vec<Constant> =
            form.constants().into_iter().filter(|c| c.exponents.len() > 1).collect();
        let mut lines: Vec<String> =
            self.definitions(form).into_iter().map(|line| format!("# {line}")).collect();
        lines.push("from sympy import Float, N, Rational, Symbol, beta\n".to_owned());
        let mut values = Vec::new();
        for constant in &iterated {
            let symbol = constant.symbol();
            lines.push(format!("{symbol} = Symbol('{symbol}', positive=True)  # {}", constant.name()));
            let digits = self.digits + SPARE_DIGITS;
            values.push(format!(
                "    {symbol}: Float('{}', {digits}),\n",
                self.constant_digits(constant, digits)?
            ));
        }
        lines.push(format!("{} = {}", form.name(), form.expression(Language::Sympy)));
        lines.push(format!("values = {{\n{}}}", values.concat()));
        let digits = self.digits + SPARE_DIGITS;
        lines.push(format!("print(N(N({}, {digits}, subs=values), {}))", form.name(), self.digits));
        Ok(lines.join("\n") + "\n")
    }
}
