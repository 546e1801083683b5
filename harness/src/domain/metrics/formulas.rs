//! The metrics' formulas as the report shows them.

use serde::Serialize;

/// A number of a comparison, and how it is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Formula {
    /// What tables call it.
    pub name: &'static str,
    /// The formula in MathML, with estimate e, reference r, the reference's standard error s, and n
    /// values.
    pub mathml: &'static str,
    /// What it tells.
    pub meaning: &'static str,
}

/// Every number that a comparison shows.
pub const FORMULAS: &[Formula] = &[
    Formula {
        name: "relMSE",
        mathml: "<mfrac><mn>1</mn><mi>n</mi></mfrac><mo>∑</mo><mfrac><msup><mrow><mo>(</mo><mi>e</mi>\
<mo>−</mo><mi>r</mi><mo>)</mo></mrow><mn>2</mn></msup><mrow><msup><mi>r</mi><mn>2</mn></msup><mo>+</mo>\
<mi>ε</mi></mrow></mfrac>",
        meaning: "mean squared relative error; ε turns it into an absolute one where the reference is \
nearly black",
    },
    Formula {
        name: "ε",
        mathml: "<msup><mrow><mo>(</mo><mn>0.01</mn><mo>·</mo><mfrac><mn>1</mn><mi>n</mi></mfrac>\
<mo>∑</mo><mo>|</mo><mi>r</mi><mo>|</mo><mo>)</mo></mrow><mn>2</mn></msup>",
        meaning: "in the quantity's unit squared, so that relMSE does not depend on the unit",
    },
    Formula {
        name: "RMSE",
        mathml: "<msqrt><mfrac><mn>1</mn><mi>n</mi></mfrac><mo>∑</mo><msup><mrow><mo>(</mo><mi>e</mi>\
<mo>−</mo><mi>r</mi><mo>)</mo></mrow><mn>2</mn></msup></msqrt>",
        meaning: "root of the mean squared error, in the quantity's unit",
    },
    Formula {
        name: "energy",
        mathml: "<mfrac><mrow><mo>∑</mo><mi>e</mi></mrow><mrow><mo>∑</mo><mi>r</mi></mrow></mfrac>",
        meaning: "ratio of the sums: below 1 is too dark, above 1 too bright",
    },
    Formula {
        name: "p99.9, max",
        mathml: "<msub><mi>P</mi><mn>99.9</mn></msub><mo>|</mo><mi>e</mi><mo>−</mo><mi>r</mi><mo>|</mo>\
<mo>,</mo><mi>max</mi><mo>|</mo><mi>e</mi><mo>−</mo><mi>r</mi><mo>|</mo>",
        meaning: "the worst thousandth and the worst value, in the quantity's unit",
    },
    Formula {
        name: "noise floor",
        mathml: "<mfrac><mn>1</mn><mi>n</mi></mfrac><mo>∑</mo><mfrac><msup><mi>s</mi><mn>2</mn></msup>\
<mrow><msup><mi>r</mi><mn>2</mn></msup><mo>+</mo><mi>ε</mi></mrow></mfrac>",
        meaning: "the relMSE that a perfect estimate would show, from the reference's standard error s: a \
difference that it can explain is inconclusive, and its relMSE an upper bound",
    },
    Formula {
        name: "FLIP",
        mathml: "<mfrac><mn>1</mn><mi>n</mi></mfrac><mo>∑</mo><mi>FLIP</mi><mo>(</mo><mi>t</mi><mo>(</mo>\
<mi>e</mi><mo>)</mo><mo>,</mo><mi>t</mi><mo>(</mo><mi>r</mi><mo>)</mo><mo>)</mo>",
        meaning: "what a viewer would notice when flipping between the images (Andersson et al. 2020), from 0 to 1, at 67 \
pixels a degree; t exposes by the reference, takes the curve of sRGB and 8 bits",
    },
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::metrics::EPSILON_FRACTION;

    #[test]
    fn the_formula_of_epsilon_shows_the_fraction_that_is_used() {
        let fraction = format!("<mn>{EPSILON_FRACTION}</mn>");
        let epsilon = FORMULAS.iter().find(|f| f.name == "ε");
        assert!(epsilon.is_some_and(|f| f.mathml.contains(&fraction)));
    }
}
