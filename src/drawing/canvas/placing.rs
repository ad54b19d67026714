//! The labels of a panel: requested while it is drawn, placed when all is drawn.

use super::{Canvas, Wanted};
use crate::drawing::clip::{clipped, holds, is_within};
use crate::drawing::labels::{LabelRequest, place};
use crate::drawing::shape::Shape;
use crate::drawing::sheet::{Mark, Pen, UnlabelledName};
use crate::drawing::text::{PlacedText, RichText};
use crate::text::Untrusted;
use crate::words::Language;
use kurbo::{Point, Rect, Vec2};

impl Canvas<'_> {
    /// Requests a label beside `anchor`, at least `clearance` mm away: `standard`, unless the scene renames `name`.
    pub(in crate::drawing) fn label(
        &mut self,
        name: &str,
        standard: &str,
        anchor: Point,
        clearance: f64,
        prefer: Option<Vec2>,
        priority: u8,
    ) -> &mut Wanted {
        let markup = self.shown(name, standard);
        self.ask(name, LabelRequest::new(RichText::math(&markup), anchor, clearance, prefer, priority))
    }

    /// Requests a label of the usual look; `name` is the end of its mark's id.
    pub(in crate::drawing) fn ask(&mut self, name: &str, request: LabelRequest) -> &mut Wanted {
        self.request_label(Wanted::new(format!("label-{name}"), request))
    }

    /// Requests a label of any look.
    pub(in crate::drawing) fn request_label(&mut self, wanted: Wanted) -> &mut Wanted {
        self.requests.push(Wanted { since: self.step, ..wanted });
        self.requests.last_mut().expect("a request was added")
    }

    /// The text shown for a name: `standard` unless the scene renames it.
    pub(in crate::drawing) fn shown(&self, name: &str, standard: &str) -> String {
        let renamed = self.renamed.get(name);
        renamed.map_or_else(|| standard.to_owned(), Untrusted::for_setting)
    }

    /// Places and draws the labels, and cuts off marks at the panel's edge. Labels of points outside the panel are left
    /// out. Where something is cut off or a name has no room, the panel says so, if it is given a language.
    pub(in crate::drawing) fn finish(mut self, language: Option<&Language>) {
        let leaves = |mark: &&Mark| !mark.passing && !is_within(self.frame, &mark.shape);
        let cut_from = self.marks().iter().filter(leaves).map(|mark| mark.since).min();
        if let (Some(step), Some(language), false) = (cut_from, language, self.is_part) {
            self.say("cut", language.cut_at_edge(), step);
        }
        self.cut_off();
        let mut requests = std::mem::take(&mut self.requests);
        requests.retain(|wanted| holds(self.seen(), wanted.request.anchor));
        let is_in_detail = |wanted: &Wanted| {
            let mut details = self.reserved_circles.iter();
            details.any(|(centre, radius)| (wanted.request.anchor - *centre).hypot() < *radius)
        };
        let (within, outside): (Vec<_>, Vec<_>) = requests.into_iter().partition(is_in_detail);
        let first = self.drawing.marks.len();
        let mut left_out = self.place(within);
        for (centre, radius) in std::mem::take(&mut self.reserved_circles) {
            self.obstacles.add_boxes(strips(centre, radius));
        }
        left_out.append(&mut self.place(outside));
        self.tell_unlabelled(left_out, first, language);
        let unnamed = std::mem::take(&mut self.unnamed);
        self.drawing.marks.retain(|mark| mark.id.as_ref().is_none_or(|id| !unnamed.contains(id)));
    }

    /// Places labels and draws them, those that come last after all others; returns those for which there is no room.
    fn place(&mut self, requests: Vec<Wanted>) -> Vec<UnlabelledName> {
        let (last, requests): (Vec<_>, Vec<_>) = requests.into_iter().partition(|wanted| wanted.last);
        let first = self.drawing.marks.len();
        let left_out = self.place_together(requests);
        if !last.is_empty() {
            for mark in &self.drawing.marks[first..] {
                match &mark.shape {
                    Shape::Text(text) => self.obstacles.add_texts([text.ink_box()]),
                    leader => self.obstacles.add_lines(leader.lines()),
                }
            }
            self.place_together(last);
        }
        left_out
    }

    /// Places labels at once and draws them; returns those for which there is no room, but for optional ones.
    fn place_together(&mut self, requests: Vec<Wanted>) -> Vec<UnlabelledName> {
        let request = |wanted: &Wanted| LabelRequest { short: wanted.short.clone(), ..wanted.request.clone() };
        let asked: Vec<LabelRequest> = requests.iter().map(request).collect();
        let ids: Vec<String> = match self.held {
            Some(_) => requests.iter().map(|wanted| self.id(&wanted.name)).collect(),
            None => Vec::new(),
        };
        let before = self.held.as_ref().filter(|held| !held.before.labels.is_empty());
        let before: Option<Vec<_>> =
            before.map(|held| ids.iter().map(|id| held.before.labels.get(id).copied()).collect());
        let placed = place(&asked, &self.obstacles, before.as_deref());
        if let Some(held) = &mut self.held {
            let all = ids.into_iter().zip(&placed).zip(&asked);
            let offsets = all
                .filter_map(|((id, label), asked)| Some((id, label.as_ref()?.text.ink_box().center() - asked.anchor)));
            held.now.labels.extend(offsets);
        }
        let mut left_out = Vec::new();
        for ((label, asked), wanted) in placed.into_iter().zip(asked).zip(requests) {
            let Some(label) = label else {
                let with: Vec<String> = wanted.with.iter().map(|name| self.id(name)).collect();
                self.unnamed.extend(with);
                if !wanted.optional && !asked.text.is_empty() {
                    let (text, place) = (asked.short.unwrap_or(asked.text), asked.anchor);
                    left_out.push(UnlabelledName { text, place, since: wanted.since });
                }
                continue;
            };
            self.step = wanted.before.first().map_or(wanted.since, |(first, _)| *first);
            if let Some((a, b)) = label.leader {
                self.add_mark(None, Pen::Leader, Shape::Line(a, b)).passing = wanted.passing;
            }
            for (index, (step, text)) in wanted.before.iter().enumerate() {
                let next = wanted.before.get(index + 1).map_or(wanted.since, |(next, _)| *next);
                let text = part_of(&label.text, text, wanted.request.anchor);
                self.step = *step;
                let mark = self.add_mark(None, wanted.pen, Shape::Text(text));
                (mark.number, mark.until) = (wanted.number, Some(next));
            }
            self.step = wanted.since;
            let mark = self.draw_below(&wanted.name, wanted.pen, Shape::Text(label.text));
            (mark.number, mark.passing) = (wanted.number, wanted.passing);
        }
        left_out
    }

    /// Cuts off the content's marks at the panel's edge; labels keep off the heads that vectors then have there.
    fn cut_off(&mut self) {
        // What leaves the frame at the top must not go through heading and scale.
        let (seen, below_header) = (self.seen(), self.below_header());
        let marks = &mut self.drawing.marks;
        let leaves = |mark: &Mark| !is_within(seen, &mark.shape);
        if !marks[self.content_start..].iter().any(leaves) {
            return;
        }
        // What is left of a joint or a point that is cut would say nothing.
        let is_point = |mark: &Mark| matches!(mark.pen, Pen::Joint | Pen::ImagePoint | Pen::Special);
        let content = marks.split_off(self.content_start).into_iter();
        for mark in content.filter(|mark| !(is_point(mark) && leaves(mark))) {
            let is_cut = leaves(&mark);
            let is_above = mark.shape.bounds().y0 < seen.y0;
            let area = if is_cut && is_above { below_header } else { seen };
            let mut id = mark.id;
            for shape in clipped(area, mark.shape) {
                self.obstacles.add_boxes(shape.head_box().filter(|_| is_cut));
                marks.push(Mark { id: id.take(), shape, ..mark });
            }
        }
    }
}

/// A shorter text within the box of a label, on its line, as near to the anchor as possible.
fn part_of(whole: &PlacedText, part: &RichText, anchor: Point) -> PlacedText {
    let (ink, own) = (whole.ink_box(), part.ink_box(whole.size));
    let left = (anchor.x - 0.5 * own.width()).min(ink.x1 - own.width()).max(ink.x0);
    PlacedText::new(part.clone(), whole.size, Point::new(left - own.x0, whole.origin.y)).anchored(whole.anchor)
}

/// Boxes that together cover a circle.
fn strips(centre: Point, radius: f64) -> impl Iterator<Item = Rect> {
    const COUNT: usize = 8;
    let height = 2.0 * radius / COUNT as f64;
    (0..COUNT).map(move |index| {
        let low = height * index as f64 - radius;
        // The strip's widest chord is the one nearest to the centre.
        let nearest = 0.0_f64.clamp(low, low + height);
        let half = (radius * radius - nearest * nearest).max(0.0).sqrt();
        Rect::new(-half, low, half, low + height) + centre.to_vec2()
    })
}
