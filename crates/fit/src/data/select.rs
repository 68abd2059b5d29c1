//! Which column holds what.

use super::role::{Method, Role};
use super::{DataError, DataOptions};
use crate::sheet::{Column, Sheet};

/// The columns in use: what each holds and its place.
pub(super) struct Selection {
    pub(super) method: Method,
    pub(super) columns: Vec<(Role, usize)>,
    /// Whether the places were taken for granted.
    pub(super) assumed: bool,
}

/// Chooses by `--columns`, by the names of the header, or by the order where there is none.
pub(super) fn select(sheet: &Sheet, options: &DataOptions) -> Result<Selection, DataError> {
    if let Some(text) = &options.columns {
        return told(sheet, text, options.method);
    }
    let named = sheet.header().is_some();
    let methods =
        Method::ALL.into_iter().filter(|method| options.method.is_none_or(|asked| asked == *method));
    let complete = |method: &Method| {
        let whole = *method != Method::Bounces || options.method.is_some() || sheet.columns().len() == 1;
        whole && method.needs().iter().all(|role| !candidates(sheet, *role).is_empty())
    };
    let found = methods.filter(|_| named).find(complete);
    let Some(method) = found else {
        return positional(sheet, options.method);
    };
    let mut columns = Vec::new();
    for role in method.takes() {
        let taken = |place: &usize| columns.iter().any(|(_, taken)| taken == place);
        match candidates(sheet, *role).into_iter().filter(|place| !taken(place)).collect::<Vec<_>>()[..] {
            [] if method.needs().contains(role) => return Err(missing(sheet, method)),
            [] => {}
            [place] => columns.push((*role, place)),
            [..] => {
                let problem = format!("more than one column could hold the {}", role.noun());
                return Err(columns_error(sheet, problem, &remedy(sheet, method)));
            }
        }
    }
    Ok(Selection { method, columns, assumed: false })
}

fn candidates(sheet: &Sheet, role: Role) -> Vec<usize> {
    let fits = |column: &Column| role.names().contains(&column.name.as_str());
    (0..sheet.columns().len()).filter(|&place| fits(&sheet.columns()[place])).collect()
}

/// No header: the columns in the order in which they are needed, if there are just as many.
fn positional(sheet: &Sheet, asked: Option<Method>) -> Result<Selection, DataError> {
    let method = asked.unwrap_or(Method::Coefficients);
    if sheet.header().is_some() || sheet.columns().len() != method.needs().len() {
        return Err(missing(sheet, method));
    }
    let columns = method.needs().iter().copied().zip(0..).collect();
    Ok(Selection { method, columns, assumed: true })
}

fn missing(sheet: &Sheet, method: Method) -> DataError {
    let lacking = method.needs().iter().find(|role| candidates(sheet, **role).is_empty());
    let problem = match (sheet.header(), lacking) {
        (Some(_), Some(Role::Velocity)) => "no column holds the velocity, such as g[cm/s]".to_owned(),
        (Some(_), Some(Role::Epsilon)) => "no column holds the coefficients, such as epsilon".to_owned(),
        (Some(_), Some(role)) => format!("no column holds the {}", role.noun()),
        _ => "nothing says which holds what".to_owned(),
    };
    let mut remedy = remedy(sheet, method);
    if method == Method::Coefficients && sheet.columns().len() > 1 {
        remedy += ", and --measured-as for speeds, heights or times of bounces";
    }
    columns_error(sheet, problem, &remedy)
}

fn remedy(sheet: &Sheet, method: Method) -> String {
    let keys = method.needs().iter().map(|role| role.key().to_uppercase()).collect::<Vec<_>>().join(",");
    if sheet.columns().len() < method.needs().len() {
        return format!("give a table with columns for {keys}");
    }
    let places = (1..=method.needs().len()).map(|place| place.to_string()).collect::<Vec<_>>().join(",");
    format!("give --columns {keys} by name or number, such as --columns {places}")
}

fn columns_error(sheet: &Sheet, problem: String, remedy: &str) -> DataError {
    DataError::Columns { seen: sheet.seen(), problem, remedy: remedy.to_owned() }
}

/// Reads `--columns 2,4`, `--columns v,COR,err` or `--columns velocity=2,epsilon=4`.
fn told(sheet: &Sheet, text: &str, method: Option<Method>) -> Result<Selection, DataError> {
    let parts = text.split(',').map(|part| match part.split_once('=') {
        Some((key, column)) => (Some(key.trim()), column.trim()),
        None => (None, part.trim()),
    });
    let parts = parts.collect::<Vec<_>>();
    let roles = parts.iter().filter_map(|(key, _)| key.and_then(role_of)).collect::<Vec<_>>();
    let method = method.or_else(|| {
        Method::ALL
            .into_iter()
            .find(|method| !roles.is_empty() && method.needs().iter().all(|role| roles.contains(role)))
    });
    let method = method.unwrap_or(Method::Coefficients);
    let mut columns: Vec<(Role, usize)> = Vec::new();
    for (place, (key, column)) in parts.iter().enumerate() {
        let role = match key {
            Some(key) => role_of(key).filter(|role| method.takes().contains(role)),
            None => method.takes().get(place).copied(),
        };
        let Some(role) = role else {
            let keys = method.takes().iter().map(|role| role.key()).collect::<Vec<_>>().join(", ");
            let problem = format!("'{text}' names a column for nothing that is used");
            return Err(columns_error(
                sheet,
                problem,
                &format!("give columns for {keys}, in this order or as KEY=COLUMN"),
            ));
        };
        let index = place_of(sheet, column)?;
        if columns.iter().any(|(other, taken)| *other == role || *taken == index) {
            return Err(columns_error(sheet, format!("'{text}' gives a column twice"), "give each once"));
        }
        columns.push((role, index));
    }
    if let Some(role) = method.needs().iter().find(|role| !columns.iter().any(|(given, _)| given == *role)) {
        let problem = format!("'{text}' names no column for the {}", role.noun());
        return Err(columns_error(sheet, problem, &remedy(sheet, method)));
    }
    Ok(Selection { method, columns, assumed: false })
}

fn role_of(key: &str) -> Option<Role> {
    let key = key.to_lowercase();
    Role::ALL.into_iter().find(|role| role.key() == key || (key == "g" && *role == Role::Velocity))
}

fn place_of(sheet: &Sheet, column: &str) -> Result<usize, DataError> {
    let width = sheet.columns().len();
    let named = |head: &Column| {
        head.text.eq_ignore_ascii_case(column)
            || (!head.name.is_empty() && head.name == column.to_lowercase())
    };
    let places = (0..width).filter(|&place| named(&sheet.columns()[place])).collect::<Vec<_>>();
    match (places.as_slice(), column.parse::<usize>()) {
        ([place], _) => Ok(*place),
        ([], Ok(number)) if (1..=width).contains(&number) => Ok(number - 1),
        ([], Ok(_)) => Err(columns_error(
            sheet,
            format!("there is no column {column}"),
            &format!("give a number from 1 to {width}"),
        )),
        ([], Err(_)) => Err(columns_error(
            sheet,
            format!("no column is called '{column}'"),
            "give one of these names, or a number from 1",
        )),
        _ => {
            Err(columns_error(sheet, format!("more than one column is called '{column}'"), "give its number"))
        }
    }
}
