//! What the names of a formula stand for in a program.

use crate::expr::{Expr, Form, Name, Path, Variable};

/// What a name stands for in a program.
#[derive(Clone, Debug)]
pub enum Binding {
    /// Numbers that are given when the program runs, in consecutive slots by rows; a complex entry takes two.
    Input {
        /// The first slot.
        slot: u32,
        /// Field and shape.
        form: Form,
    },
    /// A formula that is put in place.
    Formula(Expr),
    /// A real function of time that is computed elsewhere; it is asked for by this number.
    Motion(u32),
}

/// Says what the names of a formula stand for.
///
/// Slots that an operator binds (`at`, `root`, `integral`, `diff`) are `local`: what depends on one of them has to be
/// given as a [`Binding::Formula`], everything else may be an input. The local names themselves are not asked for.
pub trait Binder {
    /// What a name, or a time derivative of it, stands for.
    ///
    /// Where a derivative is not known as such (`None` for an order above 0), it is formed from the name itself.
    fn name(&self, variable: &Variable, local: &[Name]) -> Option<Binding>;

    /// What a quantity of a model stands for.
    fn path(&self, path: &Path, local: &[Name]) -> Option<Binding> {
        let _ = (path, local);
        None
    }
}

/// Binds each name of a list to a real input, in order.
///
/// # Examples
///
/// ```
/// use vibank_formula::expr::{Expr, Slots, Program};
///
/// let program = Program::compile(&Expr::read("a - b")?, &Slots(&["a", "b"]))?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Slots<'a>(pub &'a [&'a str]);

impl Binder for Slots<'_> {
    fn name(&self, variable: &Variable, _local: &[Name]) -> Option<Binding> {
        let slot = self
            .0
            .iter()
            .position(|name| *name == variable.name.as_str())?;
        (variable.order == 0).then_some(Binding::Input {
            slot: slot as u32,
            form: Form::REAL,
        })
    }
}
