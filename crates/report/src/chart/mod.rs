//! Line and point charts as SVG whose colours are CSS variables.
//!
//! One drawing serves light and dark pages and print: every colour is a class of `chart.css`, which
//! plotting libraries, with colours by value, do not offer. The legend has a column of its own, so that
//! nothing is drawn over the data. The scales are written down too, for the script that reads values off the drawing.

mod axis;
mod labels;

pub use axis::Axis;
use labels::Labels;
use std::fmt::Write as _;

/// The colours, light and dark, and the shapes of text and lines.
pub const STYLE: &str = include_str!("chart.css");

const WIDTH: f64 = 980.0;
const HEIGHT: f64 = 500.0;
const LEFT: f64 = 76.0;
const RIGHT: f64 = 650.0;
const TOP: f64 = 26.0;
const BOTTOM: f64 = 440.0;
const LEGEND: f64 = 668.0;
const LEGEND_STEP: f64 = 21.0;

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stroke {
    Solid,
    Dashed,
    Dotted,
    /// Only its points are drawn.
    None,
}

/// The mark at each point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    Circle,
    Square,
    Diamond,
    Triangle,
    Cross,
    None,
}

/// A point with what is written beside it and what a pointer on it shows.
#[derive(Clone, Debug, Default)]
pub struct Point {
    pub x: f64,
    pub y: f64,
    pub label: String,
    pub title: String,
}

/// Points that belong together.
#[derive(Clone, Debug)]
pub struct Series {
    /// The line of the legend; empty for none.
    pub name: String,
    /// The number of its colour, 0 to 8; beyond, the colour of text.
    pub colour: usize,
    pub stroke: Stroke,
    pub shape: Shape,
    pub points: Vec<Point>,
}

impl Series {
    /// Returns a line through the points.
    pub fn line(name: &str, colour: usize, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let points = points.into_iter().map(|(x, y)| Point { x, y, ..Point::default() }).collect();
        Self { name: name.to_owned(), colour, stroke: Stroke::Solid, shape: Shape::None, points }
    }

    /// Sets how the line is drawn.
    pub fn stroked(mut self, stroke: Stroke) -> Self {
        self.stroke = stroke;
        self
    }

    /// Sets the mark at each point.
    pub fn marked(mut self, shape: Shape) -> Self {
        self.shape = shape;
        self
    }
}

/// Two axes and what is drawn on them.
#[derive(Clone, Debug)]
pub struct Chart {
    /// Unique on the page.
    pub id: String,
    /// What it shows, for those who cannot see it.
    pub title: String,
    pub x: Axis,
    pub y: Axis,
    pub series: Vec<Series>,
    /// Vertical lines: where, and what is written above them.
    pub rules: Vec<(f64, String)>,
}

impl Chart {
    /// Returns an empty chart.
    pub fn new(id: &str, title: &str, x: Axis, y: Axis) -> Self {
        Self { id: id.to_owned(), title: title.to_owned(), x, y, series: Vec::new(), rules: Vec::new() }
    }

    /// Returns the chart as an `svg` element for a page that has [`STYLE`].
    pub fn svg(&self) -> String {
        self.element("")
    }

    /// Returns the chart as a file of its own.
    pub fn file(&self) -> String {
        format!("{}\n", self.element(&format!("<style>\n{STYLE}</style>\n")))
    }

    fn element(&self, style: &str) -> String {
        let id = &self.id;
        let title = escape(&self.title);
        let height = HEIGHT.max(TOP + LEGEND_STEP * (self.series.len() + 1) as f64);
        let (across, upward) = (self.x.written(LEFT, RIGHT), self.y.written(BOTTOM, TOP));
        let (label, area) = (escape(&self.x.label), format!("{LEFT} {RIGHT} {TOP} {BOTTOM}"));
        let scales =
            format!("data-x=\"{across}\" data-y=\"{upward}\" data-area=\"{area}\" data-across=\"{label}\"");
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"chart\" viewBox=\"0 0 {WIDTH} {height}\" {scales} role=\"img\" aria-labelledby=\"{id}-title\">\n<title id=\"{id}-title\">{title}</title>\n{style}"
        );
        let (width, tall) = (RIGHT - LEFT, BOTTOM - TOP);
        let _ = writeln!(
            out,
            "<clipPath id=\"{id}-clip\"><rect x=\"{LEFT}\" y=\"{TOP}\" width=\"{width}\" height=\"{tall}\"/></clipPath>"
        );
        self.grid(&mut out);
        let mut labels = Labels::within(LEFT, RIGHT, TOP, BOTTOM);
        self.rules.iter().for_each(|(at, text)| self.rule(&mut out, *at, text));
        self.series.iter().for_each(|series| self.line(&mut out, series));
        self.series.iter().for_each(|series| self.marks(&mut out, series, &mut labels));
        self.write_labels(&mut out, &mut labels);
        self.legend(&mut out);
        out + "</svg>"
    }

    fn grid(&self, out: &mut String) {
        for tick in self.x.ticks() {
            let x = round(LEFT + tick.place * (RIGHT - LEFT));
            let _ = writeln!(out, "<path class=\"grid\" d=\"M{x} {TOP}V{BOTTOM}\"/>");
            if let Some(label) = tick.label {
                let y = BOTTOM + 19.0;
                let _ = writeln!(out, "<text x=\"{x}\" y=\"{y}\" text-anchor=\"middle\">{label}</text>");
            }
        }
        for tick in self.y.ticks() {
            let y = round(BOTTOM - tick.place * (BOTTOM - TOP));
            let _ = writeln!(out, "<path class=\"grid\" d=\"M{LEFT} {y}H{RIGHT}\"/>");
            if let Some(label) = tick.label {
                let (x, y) = (LEFT - 7.0, round(y + 4.5));
                let _ = writeln!(out, "<text x=\"{x}\" y=\"{y}\" text-anchor=\"end\">{label}</text>");
            }
        }
        let (x, y) = ((LEFT + RIGHT) / 2.0, BOTTOM + 45.0);
        let middle = (TOP + BOTTOM) / 2.0;
        let (across, upward) = (escape(&self.x.label), escape(&self.y.label));
        let _ = writeln!(out, "<path class=\"frame\" d=\"M{LEFT} {TOP}V{BOTTOM}H{RIGHT}\"/>");
        let _ =
            writeln!(out, "<text class=\"axis\" x=\"{x}\" y=\"{y}\" text-anchor=\"middle\">{across}</text>");
        let _ = writeln!(
            out,
            "<text class=\"axis\" transform=\"translate(17 {middle}) rotate(-90)\" text-anchor=\"middle\">{upward}</text>"
        );
    }

    fn rule(&self, out: &mut String, at: f64, text: &str) {
        let Some(place) = self.x.place(at) else { return };
        let x = round(LEFT + place * (RIGHT - LEFT));
        let (above, text) = (TOP - 8.0, escape(text));
        let _ = writeln!(out, "<path class=\"rule\" d=\"M{x} {TOP}V{BOTTOM}\"/>");
        let _ = writeln!(out, "<text x=\"{x}\" y=\"{above}\" text-anchor=\"middle\">{text}</text>");
    }

    fn line(&self, out: &mut String, series: &Series) {
        if series.stroke == Stroke::None {
            return;
        }
        let mut path = String::new();
        let mut open = false;
        for point in &series.points {
            let Some((x, y)) = self.at(point) else {
                open = false;
                continue;
            };
            let _ = write!(path, "{}{} {}", if open { 'L' } else { 'M' }, round(x), round(y));
            open = true;
        }
        let (class, id) = (class(series), &self.id);
        let name = match &series.name {
            name if name.is_empty() => String::new(),
            name => format!(" data-name=\"{}\"", escape(name)),
        };
        let _ =
            writeln!(out, "<path class=\"line {class}\"{name} clip-path=\"url(#{id}-clip)\" d=\"{path}\"/>");
    }

    fn marks(&self, out: &mut String, series: &Series, labels: &mut Labels) {
        for point in &series.points {
            let Some((x, y)) = self.at(point).filter(|_| self.x.holds(point.x) && self.y.holds(point.y))
            else {
                continue;
            };
            if series.shape != Shape::None {
                labels.occupy(x, y);
                let title = escape(&point.title);
                let (mark, class) = (mark(series.shape, x, y), class(series));
                let _ =
                    writeln!(out, "<path class=\"mark {class}\" d=\"{mark}\"><title>{title}</title></path>");
            }
        }
    }

    /// Writes the labels of all points once every mark has its place, those of the last series first.
    fn write_labels(&self, out: &mut String, labels: &mut Labels) {
        for point in
            self.series.iter().rev().flat_map(|series| &series.points).filter(|p| !p.label.is_empty())
        {
            let Some((x, y)) = self.at(point).filter(|_| self.x.holds(point.x) && self.y.holds(point.y))
            else {
                continue;
            };
            if let Some((x, y)) = labels.find(x, y, &point.label) {
                let (x, y, text) = (round(x), round(y), escape(&point.label));
                let _ = writeln!(out, "<text class=\"point\" x=\"{x}\" y=\"{y}\">{text}</text>");
            }
        }
    }

    fn legend(&self, out: &mut String) {
        let named = self.series.iter().filter(|series| !series.name.is_empty());
        for (i, series) in named.enumerate() {
            let y = TOP + 12.0 + LEGEND_STEP * i as f64;
            let (class, name, text) = (class(series), escape(&series.name), LEGEND + 34.0);
            if series.stroke != Stroke::None {
                let end = LEGEND + 26.0;
                let _ = writeln!(out, "<path class=\"line {class}\" d=\"M{LEGEND} {y}H{end}\"/>");
            }
            if series.shape != Shape::None {
                let mark = mark(series.shape, LEGEND + 13.0, y);
                let _ = writeln!(out, "<path class=\"mark {class}\" d=\"{mark}\"/>");
            }
            let _ = writeln!(out, "<text x=\"{text}\" y=\"{}\">{name}</text>", y + 4.5);
        }
    }

    fn at(&self, point: &Point) -> Option<(f64, f64)> {
        let (x, y) = (self.x.place(point.x)?, self.y.place(point.y)?);
        // What is far outside is drawn where it leaves the picture, not at coordinates no viewer takes.
        let y = y.clamp(-3.0, 4.0);
        Some((LEFT + x * (RIGHT - LEFT), BOTTOM - y * (BOTTOM - TOP)))
    }
}

fn class(series: &Series) -> String {
    let colour = if series.colour < 9 { format!("c{}", series.colour) } else { "ink".to_owned() };
    match series.stroke {
        Stroke::Dashed => colour + " dashed",
        Stroke::Dotted => colour + " dotted",
        Stroke::Solid | Stroke::None => colour,
    }
}

fn mark(shape: Shape, x: f64, y: f64) -> String {
    let (x, y) = (round(x), round(y));
    match shape {
        Shape::Circle => format!("M{x} {y}m-4.4 0a4.4 4.4 0 1 0 8.8 0a4.4 4.4 0 1 0 -8.8 0z"),
        Shape::Square => format!("M{x} {y}m-4 -4h8v8h-8z"),
        Shape::Diamond => format!("M{x} {y}m0 -5.6l5.6 5.6l-5.6 5.6l-5.6 -5.6z"),
        Shape::Triangle => format!("M{x} {y}m0 -5.4l5 8.6h-10z"),
        Shape::Cross => {
            format!("M{x} {y}m-4.6 -3l1.6 -1.6l3 3l3 -3l1.6 1.6l-3 3l3 3l-1.6 1.6l-3 -3l-3 3l-1.6 -1.6l3 -3z")
        }
        Shape::None => String::new(),
    }
}

/// A coordinate to a twentieth of a unit, which no eye tells apart.
fn round(x: f64) -> f64 {
    (x * 20.0).round() / 20.0
}

/// Text for use between tags and in attributes.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chart_names_its_axes_and_clips_its_lines() {
        let mut chart = Chart::new("f", "A < B", Axis::linear("u", 0.0, 1.0), Axis::log("error", 1e-3, 1.0));
        chart.series.push(Series::line("far off", 2, [(0.0, 1.0), (0.5, 0.0), (1.0, 1e300)]));
        let svg = chart.svg();
        assert!(svg.contains("A &lt; B") && svg.contains(">u</text>") && svg.contains(">error</text>"));
        assert!(svg.contains("class=\"line c2\" data-name=\"far off\" clip-path=\"url(#f-clip)\""));
        assert!(svg.contains("data-x=\"linear 0 1 76 650\" data-y=\"log -3 0 440 26\""), "{svg}");
        assert!(svg.contains("M76 26M650 -1216"), "a point without a place interrupts the line: {svg}");
    }
}
