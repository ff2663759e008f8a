//! JSON: the result for programs.

use std::path::Path;

use check::answer::Judged;
use check::blind_spots::{BlindSpots, Showing};
use check::evidence::Known;
use check::explanations::{But, Conversion};
use check::names;
use check::reading::Cause;
use check::scene::Scene;
use check::verdict::{Check, Finding, Near, Set};
use check::workspace;
use common::rtweekend::Color;
use serde_json::{Value, json};
use slips::Slip;

/// One object. Names of slips, probes, causes and verdicts never change.
pub(crate) fn json(judged: &Judged, report: Option<&Path>) -> String {
    let verdict = match &judged.check {
        Check::Right(_) => "right",
        Check::Near(_) => "right-but",
        Check::Wrong(finding) if finding.levels <= 1 => "within-one-level",
        Check::Wrong(_) | Check::WrongShape { .. } | Check::Another { .. } => "wrong",
        Check::NotAPicture { .. } => "not-a-picture",
    };
    let cause =
        |cause: &Cause| json!({ "name": cause.name, "problem": cause.problem, "fix": cause.fix });
    let finding = judged.check.finding();
    let sets = finding.map(|finding| &finding.sets[..]).unwrap_or_default();
    let object = json!({
        "chapter": judged.scene.chapter.name(),
        "probe": judged.scene.probe.map(|probe| probe.name),
        "picture": judged.name,
        "size": size(&judged.check),
        "edition": edition(&judged.check),
        "verdict": verdict,
        "exit_code": judged.check.exit_code(),
        "cause": judged.check.cause().or(judged.encoding.as_ref()).map(cause),
        "other_scenes": judged.check.others().iter().map(other_scene).collect::<Value>(),
        "blind_spots": judged.blind_spots.as_ref().map(blind_spots),
        "but": finding.and_then(|finding| Some(but(finding, finding.near.as_ref()?))),
        "difference": finding.map(difference),
        "diagnosis": sets.iter().map(|set| diagnosis(&judged.known, &judged.scene, set)).collect::<Value>(),
        "sights": finding.map(|finding| finding.seen().collect::<Vec<_>>()),
        "lead_in_bits": finding.map(|finding| finding.lead.round()),
        "report": report.map(names::spelled),
    });
    format!("{object:#}\n")
}

fn size(check: &Check) -> Option<[u32; 2]> {
    match check {
        Check::Right(right) => Some([right.width, right.height]),
        other => other
            .finding()
            .map(|finding| [finding.yours.width(), finding.yours.height()]),
    }
}

/// The version of the book that the picture is judged by.
fn edition(check: &Check) -> Option<&'static str> {
    let scene = match check {
        Check::Right(right) => Some(right.scene),
        other => other.finding().map(|finding| finding.scene),
    };
    scene.map(|scene| scene.edition.name())
}

/// What a right picture has that the book's does not have.
fn but(finding: &Finding, near: &Near) -> Value {
    let color = |color: Color| color.to_array();
    let colors = |sky: [Color; 2]| sky.map(color);
    let but = near.but.iter().map(|but| match but {
        But::Antialiased { samples, .. } => json!({ "name": "antialiased", "samples": samples }),
        But::Curve(curve) => json!({ "name": "curve", "power": curve.power }),
        But::Degraded(degradation) => json!({ "name": "degraded", "said": degradation.clause() }),
    });
    json!({
        "said": finding.but(),
        "sky": near.scene.chosen.sky.map(colors),
        "sphere": near.scene.chosen.paint.map(color),
        "blue": near.scene.chosen.blue,
        "besides": but.collect::<Value>(),
        "pixels_off": near.left.off,
        "pixels_far_off": near.left.far,
    })
}

/// The chapter's own scene has no probe.
fn other_scene(scene: &Scene) -> Value {
    json!({ "chapter": scene.chapter.name(), "probe": scene.probe.map(|probe| probe.name) })
}

fn blind_spots(blind_spots: &BlindSpots) -> Value {
    let names = |slips: &[&Slip]| slips.iter().map(|slip| slip.name).collect::<Value>();
    let showing = |showing: &Showing| {
        json!({
            "probe": showing.scene.probe.map(|probe| probe.name),
            "width": showing.width,
            "change": showing.scene.change(showing.width).lines().collect::<Vec<_>>(),
            "mistakes": names(&showing.slips),
        })
    };
    json!({
        "shown_by": blind_spots.shown_by.iter().map(showing).collect::<Value>(),
        "only_by_law": names(&blind_spots.by_law),
    })
}

fn difference(finding: &Finding) -> Value {
    let Some(difference) = &finding.difference else {
        return Value::Null;
    };
    json!({
        "pixels": difference.count,
        "of": difference.total,
        "levels": finding.levels,
        "columns": difference.columns,
        "rows": difference.rows,
        "first": {
            "column": difference.first.0,
            "row": difference.first.1,
            "expected": difference.expected,
            "got": difference.actual,
        },
    })
}

fn diagnosis(known: &Known, scene: &Scene, set: &Set) -> Value {
    let conversion = match set.conversion {
        Conversion::Printed => "printed",
        Conversion::Clamped => "clamped",
        Conversion::Wrapped => "wrapped",
    };
    let edition = set.scene.edition;
    let names = |mistake: &Vec<&Slip>| mistake.iter().map(|slip| slip.name).collect::<Value>();
    let probe = set.telling.as_ref().map(|telling| {
        let group = |group: &Vec<usize>| group.iter().map(|&n| names(&set.mistakes[n])).collect();
        json!({
            "name": telling.probe.name,
            "change": telling.probe.lines(scene.chapter).lines().collect::<Vec<_>>(),
            "tells_apart": telling.groups.iter().map(group).collect::<Vec<Value>>(),
        })
    });
    json!({
        "bits": set.bits.round(),
        "pixels_off": set.left.off,
        "pixels_far_off": set.left.far,
        "conversion": conversion,
        "edition": edition.name(),
        "mistakes": set.mistakes.iter().map(|mistake| mistake.iter().map(|slip| slip_as_json(slip, &set.scene, known)).collect()).collect::<Vec<Value>>(),
        "probe": probe,
    })
}

fn slip_as_json(slip: &Slip, scene: &Scene, known: &Known) -> Value {
    let words = known.words(slip, scene);
    json!({
        "name": slip.name,
        "probably": words.wrong,
        "should_be": words.right,
        "why": words.why,
        "page": slip.page,
        "read": workspace::page(slip),
        "yours": known.line_of(slip, scene).map(|line| line.to_string()),
        "code": workspace::source(slip),
    })
}
