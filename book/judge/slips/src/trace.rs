//! Tracing: the numbers of one pixel on their way from the viewport to the levels.

use common::rtweekend::*;
use interpreter::{TracedValue, format_number};

use crate::output::Output;

/// A row in the [trace](Output::trace) of a pixel, the values from which its color is computed: a
/// label and a value.
pub struct TraceRow {
    /// The name of the variable, `oc`, then `oc, again` and `oc, again 2` when it gets a value for
    /// the second and third time; or the name of a step around these, such as `levels`.
    pub label: String,
    /// The value as text: a number, a vector as `(x, y, z)`, `true`, `false`, `none`, or the three
    /// levels with blanks between them.
    pub value: String,
}

impl TraceRow {
    fn new(label: impl Into<String>, value: String) -> Self {
        let label = label.into();
        Self { label, value }
    }
}

impl Output {
    /// Traces the computation of the `n`th printed pixel, from 0. The rows are its point on the
    /// viewport, the origin and the direction of its ray, then the values of the variables in the
    /// order of the computation, then the color and the levels.
    ///
    /// `n` has to be below width times height. If the program stops early, the rows end where it
    /// stops, and the levels are all 0.
    pub fn trace(&self, n: u32) -> Vec<TraceRow> {
        let mut rows = Vec::new();
        if let Some(ray) = self.ray(n) {
            rows.push(TraceRow::new(
                "point on the viewport",
                vector(ray.origin + ray.direction),
            ));
            rows.push(TraceRow::new("origin", vector(ray.origin)));
            rows.push(TraceRow::new("direction", vector(ray.direction)));
        }
        rows.extend(labeled(self.traced_values(n)));
        rows.extend(self.color(n).map(|it| TraceRow::new("color", vector(it))));
        let [r, g, b] = self.pixel(n);
        rows.push(TraceRow::new("levels", format!("{r} {g} {b}")));
        rows
    }
}

/// Labels the values of a trace by their names. A name that comes again, as with the second
/// sphere, is numbered. The values of `return` and those of a camera's constructor are left out.
fn labeled(values: Vec<TracedValue>) -> Vec<TraceRow> {
    let mut rows: Vec<TraceRow> = Vec::new();
    for TracedValue {
        function,
        name,
        value,
    } in values
    {
        let (is_of_the_way, value) = (function.starts_with("Camera::"), value.to_string());
        let Some(name) = name.filter(|_| !is_of_the_way && !value.is_empty()) else {
            continue;
        };
        let again = format!("{name}, again");
        let is_same = |row: &&TraceRow| row.label == *name || row.label.starts_with(&again);
        let label = match rows.iter().filter(is_same).count() {
            0 => name.to_string(),
            1 => again,
            n => format!("{again} {n}"),
        };
        rows.push(TraceRow { label, value });
    }
    rows
}

/// Lays several traces out as a table in plain text: a line for each label, in the order in which
/// the traces first have them, with the label and the value of each trace between tabs. The value
/// is `none` where a trace lacks the label. Empty without traces.
pub fn trace_table(traces: &[Vec<TraceRow>]) -> String {
    let mut labels: Vec<&str> = Vec::new();
    for row in traces.iter().flatten() {
        if !labels.contains(&&*row.label) {
            labels.push(&row.label);
        }
    }
    let line = |label: &str| {
        let values = traces.iter().map(|rows| {
            let row = rows.iter().find(|row| row.label == label);
            row.map_or("none", |row| &row.value)
        });
        format!("{label}\t{}", values.collect::<Vec<_>>().join("\t"))
    };
    labels.into_iter().map(line).collect::<Vec<_>>().join("\n")
}

fn vector(of: Vec3) -> String {
    let [x, y, z] = of.to_array().map(format_number);
    format!("({x}, {y}, {z})")
}
