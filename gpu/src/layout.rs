//! What Rust and WGSL both know, compared without any GPU: for tests, which panic where it differs.

use crate::Shader;
use naga::{Expression, Literal, Module, TypeInner};

/// A shader's source, parsed.
///
/// # Panics
/// If it is not valid.
pub fn module(shader: &Shader) -> Module {
    naga::front::wgsl::parse_str(&shader.source()).expect("valid WGSL")
}

/// Size of a struct, and name and offset of its members.
///
/// # Panics
/// If there is no such struct.
pub fn layout(module: &Module, name: &str) -> (usize, Vec<(String, usize)>) {
    let mut types = module.types.iter().map(|(_, ty)| ty);
    let found = types.find(|ty| ty.name.as_deref() == Some(name));
    let Some(TypeInner::Struct { members, span }) = found.map(|ty| &ty.inner) else {
        panic!("no struct `{name}`");
    };
    let member = |m: &naga::StructMember| (m.name.clone().unwrap_or_default(), m.offset as usize);
    (*span as usize, members.iter().map(member).collect())
}

/// Value of a `const` of type f32.
///
/// # Panics
/// If there is no such constant.
pub fn constant(module: &Module, name: &str) -> f32 {
    match initial(module, name) {
        Some(Expression::Literal(Literal::F32(value))) => *value,
        other => panic!("`{name}` is {other:?}"),
    }
}

/// Value of a `const` of type u32.
///
/// # Panics
/// If there is no such constant.
pub fn constant_u32(module: &Module, name: &str) -> u32 {
    match initial(module, name) {
        Some(Expression::Literal(Literal::U32(value))) => *value,
        other => panic!("`{name}` is {other:?}"),
    }
}

pub use crate::assert_layout;

fn initial<'a>(module: &'a Module, name: &str) -> Option<&'a Expression> {
    let mut constants = module.constants.iter().map(|(_, constant)| constant);
    let found = constants.find(|c| c.name.as_deref() == Some(name));
    found.map(|c| &module.global_expressions[c.init])
}

/// Length of the array that a variable holds, if it is fixed.
pub fn array_length(module: &Module, variable: &str) -> Option<u32> {
    let mut variables = module.global_variables.iter().map(|(_, v)| v);
    let found = variables.find(|v| v.name.as_deref() == Some(variable))?;
    match module.types[found.ty].inner {
        TypeInner::Array {
            size: naga::ArraySize::Constant(length),
            ..
        } => Some(length.get()),
        _ => None,
    }
}

/// Checks that the struct of this name in a shader has the members of a Rust struct, at the same
/// places, and its size.
#[macro_export]
macro_rules! assert_layout {
    ($shader:expr, $rust:ident, [$($member:ident),*]) => {
        let members = vec![
            $((stringify!($member).to_owned(), std::mem::offset_of!($rust, $member))),*
        ];
        assert_eq!(
            $crate::layout::layout(&$crate::layout::module(&$shader), stringify!($rust)),
            (size_of::<$rust>(), members),
            "{} in {}",
            stringify!($rust),
            $shader.label
        );
    };
}
