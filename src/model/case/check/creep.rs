//! Materials that creep: the keys that each model needs, those without effect, and curves stiffer than the dynamic stiffness.

use crate::case::diagnostic::Finding;
use crate::case::fields::number;
use crate::case::model::{CreepModel, MaterialKeys, WorkingCurveShape};
use crate::case::schema::{Key, KeyValue};
use crate::physics::rope::TensionTable;
use crate::physics::rope::working_curve::{CurveEnd, CurveShape, MeanCurve, WorkingCurve};

/// Places of a curve at which its stiffness is compared.
const PLACES: u32 = 50;

/// Checks of a material's creep.
pub(crate) fn of_material(material: &MaterialKeys<'_>) -> Vec<Finding> {
    let mut found = without_effect(material);
    let Some(model) = material.creep_model.value() else {
        return found;
    };
    if model == CreepModel::None {
        return found;
    }
    found.extend(contradictions(material));
    let dynamic = "add `dynamic_ea_n = ...`: the stiffness that motion meets";
    found.extend(material.dynamic_ea_n.if_missing(dynamic));
    let slow = "add `slow_damping_n_s = ...`: it decides how fast the rope creeps";
    found.extend(material.slow_damping_n_s.if_missing(slow));
    if model == CreepModel::Syrope {
        found.extend(working_curves(material));
    }
    if found.is_empty() {
        found.extend(softer_in_motion(material, model));
    }
    found
}

/// Keys of a model that is not given.
fn without_effect(material: &MaterialKeys<'_>) -> Vec<Finding> {
    let model = &material.creep_model;
    let (none, creeps) = (
        model.is(&CreepModel::None),
        model.is(&CreepModel::Viscoelastic),
    );
    let of_both = [
        idle(&material.dynamic_ea_n),
        idle_number(&material.dynamic_ea_per_tension),
        idle(&material.slow_damping_n_s),
        idle_number(&material.fast_damping_n_s),
        idle(&material.initial_mean_tension_n),
    ];
    let of_syrope = [
        idle(&material.working_curve)
            .filter(|_| !material.working_curve.is(&WorkingCurveShape::Linear)),
        idle(&material.working_curve_shape),
        idle(&material.permanent_strain_ratio),
        idle(&material.working_curve_ea_n),
        idle_number(&material.past_tension_n),
    ];
    let problem = match model.is_given() {
        false => "has no effect: creep_model is not given".to_owned(),
        true => format!(
            "has no effect: creep_model is \"{}\"",
            model.value().map_or("none", CreepModel::name)
        ),
    };
    let mut found = Vec::new();
    if none {
        let remedy = "add `creep_model = \"viscoelastic\"` or \"syrope\", or remove it";
        found.extend(of_both.iter().flatten().map(|at| at(&problem, remedy)));
    }
    if none || creeps {
        let remedy = "set `creep_model = \"syrope\"`, or remove it";
        found.extend(of_syrope.iter().flatten().map(|at| at(&problem, remedy)));
    }
    found
}

/// Makes a finding at the name of a key, with problem and remedy.
type FindingReporter<'k> = Box<dyn Fn(&str, &str) -> Finding + 'k>;

/// A key that is given.
fn idle<'k, T: KeyValue>(key: &'k Key<'_, T>) -> Option<FindingReporter<'k>> {
    let report = move |problem: &str, remedy: &str| key.finding_at_name(problem, remedy);
    key.is_given()
        .then(|| Box::new(report) as FindingReporter<'k>)
}

/// A number that is given; zero says no more than no number.
fn idle_number<'k>(key: &'k Key<'_, f64>) -> Option<FindingReporter<'k>> {
    idle(key).filter(|_| !key.is(&0.0))
}

/// Keys that say something else of the same rope.
fn contradictions(material: &MaterialKeys<'_>) -> Vec<Finding> {
    let mut found = Vec::new();
    if material.ei_n_m2.get().is_some_and(|ei| *ei > 0.0) {
        let remedy = "set it to 0, or creep_model to \"none\"";
        let problem = "a rope that creeps does not bend";
        found.push(material.ei_n_m2.finding(problem, remedy));
    }
    if material
        .dynamic_stiffness
        .given()
        .is_some_and(|given| given.name() != "none")
    {
        let problem = "is given beside creep_model, which has a dynamic stiffness of its own";
        let remedy = "leave one of the two out";
        found.push(material.dynamic_stiffness.finding_at_name(problem, remedy));
    }
    for damping in [&material.axial_damping_n_s, &material.axial_damping_ratio] {
        let problem = "has no effect on a rope that creeps";
        let remedy = "leave it out; its dampers are slow_damping_n_s and fast_damping_n_s";
        let given = damping.is_given() && !damping.is(&0.0);
        found.extend(given.then(|| damping.finding_at_name(problem, remedy)));
    }
    found
}

/// What working curves need.
fn working_curves(material: &MaterialKeys<'_>) -> Vec<Finding> {
    let mut found = Vec::new();
    let curve = "a Syrope rope needs its original curve: give `strain` and `tension_n` in the place of ea_n";
    found.extend(material.strain.if_missing(curve));
    let (ratio, ea) = (
        &material.permanent_strain_ratio,
        &material.working_curve_ea_n,
    );
    if ratio.is_given() && ea.is_given() {
        let problem = "the end of the working curves is given twice, by permanent_strain_ratio and by working_curve_ea_n";
        found.push(ea.finding_at_name(problem, "keep one of the two"));
    } else if !ea.is_given() {
        let remedy = "add `permanent_strain_ratio = ...`, or `working_curve_ea_n`";
        found.extend(ratio.if_missing(remedy));
    }
    let k = &material.working_curve_shape;
    match material.working_curve.value() {
        Some(WorkingCurveShape::Linear) => {
            let problem = "has no effect: working_curve is \"linear\"";
            let remedy = "set working_curve to \"quadratic\" or \"exponential\", or remove it";
            found.extend(k.is_given().then(|| k.finding_at_name(problem, remedy)));
        }
        Some(shape) => {
            let remedy = format!(
                "the curve is {}: add `working_curve_shape = ...`",
                shape.name()
            );
            found.extend(k.if_missing(remedy));
            let quadratic = shape == WorkingCurveShape::Quadratic;
            if quadratic && k.value().is_some_and(|k| k.abs() > 1.0) {
                let problem = "makes a quadratic curve fall";
                found.push(k.finding(problem, "give a number from -1 to 1"));
            }
        }
        None => {}
    }
    found
}

/// A curve that is as stiff as the dynamic stiffness or stiffer, at a mean tension that may be met.
fn softer_in_motion(material: &MaterialKeys<'_>, model: CreepModel) -> Option<Finding> {
    let (dynamic, growth) = (
        material.dynamic_ea_n.value()?,
        material.dynamic_ea_per_tension.value()?,
    );
    let past = material.past_tension_n.value()?;
    let (curve, greatest) = curve(material, model)?;
    let last = curve.strain_at(greatest, 0.0);
    let first = curve.strain_at(past.min(greatest), 0.0);
    let stiff = |tension: f64, slope: f64| slope >= dynamic + growth * tension;
    let peak = |i: u32| first + (last - first) * f64::from(i) / f64::from(PLACES);
    let points = (0..=PLACES).flat_map(|i| {
        let (curve, peak) = (&curve, peak(i));
        let slack = curve.slack(peak);
        // Along the working curve up to the original one, and on this.
        let within =
            (1..=8).map(move |k| slack + (peak - slack) * f64::from(k) / 8.0 * (1.0 - 1e-9));
        let on_both = within.map(move |x| curve.at(x, peak));
        on_both.chain([curve.at(peak, 0.0)])
    });
    let worst = points
        .filter(|point| point.tension > 0.0)
        .find(|point| stiff(point.tension, point.by_strain))?;
    let problem = format!(
        "motion would meet no more stiffness than slow loading: {} N at a mean tension of {} N",
        number(rounded(worst.by_strain)),
        number(rounded(worst.tension))
    );
    let remedy = match model {
        CreepModel::Syrope => {
            "give a greater dynamic_ea_n, a greater past_tension_n, or softer working curves"
        }
        _ => "give a dynamic_ea_n above the static stiffness",
    };
    Some(material.dynamic_ea_n.finding(problem, remedy))
}

/// Three digits of a number.
fn rounded(value: f64) -> f64 {
    let scale = 10f64.powf(value.abs().max(1e-300).log10().floor() - 2.0);
    (value / scale).round() * scale
}

/// The mean curve of a material, and a tension up to which it is known \[N\].
fn curve(material: &MaterialKeys<'_>, model: CreepModel) -> Option<(MeanCurve, f64)> {
    if let Some(ea) = material.ea_n.value() {
        return Some((MeanCurve::Linear(ea), ea));
    }
    let (strain, tension) = (material.strain.get()?, material.tension_n.get()?);
    let between = material.tension_interpolation.value()?.into();
    let table = TensionTable::interpolated(strain, tension, between)?;
    let greatest = *tension.last()?;
    if model == CreepModel::Viscoelastic {
        return Some((MeanCurve::Table(table), greatest));
    }
    let end = match material.permanent_strain_ratio.value() {
        Some(ratio) => CurveEnd::Ratio(ratio),
        None => CurveEnd::Stiffness(material.working_curve_ea_n.value()?),
    };
    let k = material.working_curve_shape.value();
    let shape = match material.working_curve.value()? {
        WorkingCurveShape::Linear => CurveShape::Linear,
        WorkingCurveShape::Quadratic => CurveShape::Quadratic(k?),
        WorkingCurveShape::Exponential => CurveShape::Exponential(k?),
    };
    let curve = MeanCurve::Syrope(table, WorkingCurve { shape, end });
    Some((curve, greatest))
}
