//! The figure of an item, drawn for the data of its instance.

use super::Scene;
use crate::expr::Name;
use crate::figure::{FreeError, Given, Picture};
use crate::math::Math;

impl Scene<'_, '_> {
    /// The figure; `None` where the item has none, or where its places have no value for these data.
    pub fn picture(&self) -> Option<Picture> {
        let figure = self.solution.template().figure.as_ref()?;
        self.solution.note_figure();
        figure.picture(self, &self.scope(), &self.language).ok()
    }

    /// The free-body diagrams; `None` where the item has none.
    ///
    /// # Errors
    ///
    /// [`FreeError`] where they do not show the forces of the model for these data.
    pub fn free_picture(&self) -> Option<Result<Picture, FreeError>> {
        let figure = self.solution.template().figure.as_ref()?;
        let id = format!("{}-free", self.scope());
        figure
            .has_free()
            .then(|| figure.free_picture(self, &id, &self.language))
    }
}

impl Given for Scene<'_, '_> {
    fn number(&self, name: &Name) -> Option<f64> {
        let node = self.solution.template().graph.find(name)?;
        self.solution.evaluation().real(node).ok()
    }

    fn value(&self, name: &Name) -> Option<Math> {
        let template = self.solution.template();
        let node = template.graph.find(name)?;
        let info = template.info(node).filter(|info| info.units.is_some())?;
        Some(self.value(node, info))
    }
}
