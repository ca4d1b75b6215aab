//! What clients want to see of the form of curves and surfaces.
//!
//! The curves and surfaces of an object are collected once for all clients, and again when its data are others. What a client
//! looks at is drawn again where they, or what all of it has in common, have changed.

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use katydid_session::analysis::{self, Measure, Subjects};
use katydid_session::display::{self, Geometry, Shown};
use katydid_session::protocol::{AnalysisView, CombMeasure, Probe, Probed};
use katydid_solver::{Engine, Inputs};
use uuid::Uuid;

/// The number of a client among those of a document.
pub type ClientId = u64;

/// An analysis for a client.
#[derive(Debug)]
pub struct Analysed {
    /// Whether it is as coarse as it may be.
    pub is_draft: bool,
    /// The objects of which it is another; nothing for those that show nothing any more.
    pub objects: Vec<(Uuid, Option<Geometry>)>,
    /// What is said of it.
    pub about: About,
}

/// What is said of an analysis besides what is drawn.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct About {
    /// How the combs were measured.
    pub comb: Option<CombMeasure>,
    /// What there was too much of.
    pub left_out: Vec<String>,
}

/// What a client is to be told.
#[derive(Debug)]
pub enum Finding {
    /// An analysis.
    Analysed(Analysed),
    /// The answers of a round.
    Probed(u32, Vec<Option<Probed>>),
}

/// What clients look at.
#[derive(Debug, Default)]
pub struct Analyses {
    clients: HashMap<ClientId, Asked>,
    /// The curves and surfaces of objects, as far as they were looked at.
    subjects: HashMap<Uuid, Arc<Subjects>>,
    is_draft: bool,
}

/// What a client looks at.
#[derive(Debug, Default)]
struct Asked {
    analysis: Option<AnalysisView>,
    probes: Vec<Probe>,
    round: u32,
    /// What it has: of which curves and surfaces, and how they were measured; nothing of what was asked for otherwise.
    drawn: HashMap<Uuid, Option<(Arc<Subjects>, Measure)>>,
    about: About,
    /// What it was answered, and in which round.
    probed: (u32, Vec<Option<Probed>>),
    /// Whether analysis and probes are to be looked at again.
    is_due: [bool; 2],
    /// Whether what it has is coarse.
    is_coarse: bool,
}

impl Analyses {
    /// What a client looks at from now on.
    pub fn analyse(&mut self, client: ClientId, analysis: Option<AnalysisView>) {
        let asked = self.clients.entry(client).or_default();
        let look =
            |view: &Option<AnalysisView>| view.clone().map(|view| AnalysisView { objects: None, ..view });
        if look(&asked.analysis) != look(&analysis) {
            asked.drawn.values_mut().for_each(|drawn| *drawn = None);
        }
        asked.analysis = analysis;
        asked.is_due[0] = true;
    }

    /// The places that a client asks about from now on.
    pub fn probe(&mut self, client: ClientId, round: u32, probes: Vec<Probe>) {
        let asked = self.clients.entry(client).or_default();
        (asked.round, asked.probes) = (round, probes);
        asked.is_due[1] = true;
    }

    /// A client is gone.
    pub fn leave(&mut self, client: ClientId) {
        self.clients.remove(&client);
        self.tidy();
    }

    /// These objects have other data, or are shown otherwise.
    pub fn touch(&mut self, objects: &[Uuid]) {
        if objects.is_empty() {
            return;
        }
        for id in objects {
            self.subjects.remove(id);
        }
        self.all_due();
    }

    /// Everything is to be looked at again.
    pub fn touch_all(&mut self) {
        self.subjects.clear();
        self.all_due();
    }

    fn all_due(&mut self) {
        for asked in self.clients.values_mut() {
            asked.is_due = [asked.analysis.is_some() || !asked.drawn.is_empty(), !asked.probes.is_empty()];
        }
    }

    /// Whether things are being dragged.
    pub fn set_draft(&mut self, is_draft: bool) {
        self.is_draft = is_draft;
        if !is_draft {
            self.clients
                .values_mut()
                .filter(|asked| asked.is_coarse)
                .for_each(|asked| asked.is_due[0] = true);
        }
    }

    /// Whether a client looks at colours of curvatures, or at stripes.
    pub fn has_colours(&self) -> bool {
        self.clients.values().any(|asked| asked.analysis.as_ref().is_some_and(|view| view.colours))
    }

    /// Whether there is something to look at again.
    pub fn is_due(&self) -> bool {
        self.clients.values().any(|asked| asked.is_due.contains(&true))
    }

    /// Looks at what is due; what `go_on` denies stays due.
    pub fn look(&mut self, engine: &Engine, go_on: impl Fn() -> bool + Sync) -> Vec<(ClientId, Finding)> {
        let Self { clients, subjects, is_draft } = self;
        let mut collection = Collection::new(engine, subjects);
        let mut findings = Vec::new();
        for (client, asked) in clients.iter_mut() {
            if asked.is_due[0] && go_on() {
                findings.extend(asked.look(&mut collection, *is_draft, &go_on).map(|found| (*client, found)));
            }
            if asked.is_due[1] && go_on() {
                findings.extend(asked.ask(&mut collection).map(|found| (*client, found)));
            }
        }
        self.tidy();
        findings
    }

    /// Forgets the curves and surfaces that nobody looks at.
    fn tidy(&mut self) {
        if self.clients.values().all(|asked| asked.analysis.is_none() && asked.probes.is_empty()) {
            self.subjects.clear();
        }
    }
}

impl Asked {
    fn look(
        &mut self,
        collection: &mut Collection<'_>,
        is_draft: bool,
        go_on: &(impl Fn() -> bool + Sync),
    ) -> Option<Finding> {
        let analysis = self.analysis.clone().unwrap_or_default();
        let wanted: Vec<Uuid> = match (&self.analysis, &analysis.objects) {
            (None, _) => Vec::new(),
            (Some(_), Some(objects)) => objects.clone(),
            (Some(_), None) => collection.shown(),
        };
        let mut seen = HashSet::new();
        let mut all: Vec<(Uuid, Arc<Subjects>)> = Vec::new();
        for id in wanted.into_iter().filter(|id| seen.insert(*id)) {
            if !go_on() {
                return None;
            }
            all.extend(
                collection.of(id).filter(|subjects| !subjects.is_empty()).map(|subjects| (id, subjects)),
            );
        }
        let list: Vec<&Subjects> = all.iter().map(|(_, subjects)| subjects.as_ref()).collect();
        let before = self.about.comb.map(|comb| comb.scale).filter(|_| is_draft);
        let measured = analysis::measure(&list, &analysis, is_draft, before);
        let is_same = |(id, subjects): &(Uuid, Arc<Subjects>)| {
            let drawn = self.drawn.get(id).and_then(Option::as_ref);
            drawn.is_some_and(|(had, measure)| Arc::ptr_eq(had, subjects) && *measure == measured.measure)
        };
        let due: Vec<(Uuid, &Subjects)> =
            all.iter().filter(|one| !is_same(one)).map(|(id, subjects)| (*id, subjects.as_ref())).collect();
        let mut objects = analysis::encode(&due, &analysis, &measured.measure, go_on);
        if objects.len() < due.len() {
            return None;
        }
        let kept: HashSet<Uuid> = all.iter().map(|(id, _)| *id).collect();
        objects.extend(self.drawn.keys().filter(|id| !kept.contains(id)).map(|id| (*id, None)));
        let about = About { comb: measured.comb, left_out: measured.left_out };
        self.drawn = all.into_iter().map(|(id, subjects)| (id, Some((subjects, measured.measure)))).collect();
        (self.is_due[0], self.is_coarse) = (false, is_draft);
        if objects.is_empty() && about == self.about {
            return None;
        }
        self.about = about.clone();
        Some(Finding::Analysed(Analysed { is_draft, objects, about }))
    }

    fn ask(&mut self, collection: &mut Collection<'_>) -> Option<Finding> {
        self.is_due[1] = false;
        let found = |probe: &Probe| analysis::probe(collection.of(probe.object)?.as_ref(), probe);
        let probed: Vec<Option<Probed>> = self.probes.iter().map(found).collect();
        if self.probed == (self.round, probed.clone()) {
            return None;
        }
        self.probed = (self.round, probed.clone());
        Some(Finding::Probed(self.round, probed))
    }
}

/// Collects curves and surfaces of objects.
struct Collection<'a> {
    engine: &'a Engine,
    known: &'a mut HashMap<Uuid, Arc<Subjects>>,
    places: HashMap<Uuid, usize>,
    inputs: Inputs<'a>,
}

impl<'a> Collection<'a> {
    fn new(engine: &'a Engine, known: &'a mut HashMap<Uuid, Arc<Subjects>>) -> Self {
        let objects = engine.document().objects.iter();
        let places = objects.enumerate().rev().map(|(at, object)| (object.id, at)).collect();
        Self { engine, known, places, inputs: Inputs::new(engine) }
    }

    /// The objects that show something.
    fn shown(&self) -> Vec<Uuid> {
        let objects = self.engine.document().objects.iter();
        objects.filter(|object| display::is_shown(object)).map(|object| object.id).collect()
    }

    /// What an object shows; nothing while it is not solved.
    fn of(&mut self, id: Uuid) -> Option<Arc<Subjects>> {
        if let Some(known) = self.known.get(&id) {
            return Some(Arc::clone(known));
        }
        let at = *self.places.get(&id)?;
        let object = self.engine.document().objects.get(at).filter(|object| display::is_shown(object))?;
        let report = self.engine.report(at)?;
        let inputs = if display::draws_inputs(object) { self.inputs.of(at) } else { Vec::new() };
        let shown = Shown { object, outputs: &report.outputs, inputs: &inputs };
        let subjects = Arc::new(Subjects::of(&shown, &self.engine.options().rules));
        self.known.insert(id, Arc::clone(&subjects));
        Some(subjects)
    }
}
