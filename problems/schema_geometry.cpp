// Shapes that are given by formulas or made of others, and what is made of shapes.

#include <array>

#include "problems/schema.hpp"

namespace rfm {
namespace {

constexpr Status later = Status::later;
constexpr unsigned point = vector_value;

constexpr auto rows = std::to_array<SchemaRow>({
    {"geometry.shapes.*.conic", numbers_value, alternative,
     "[a, b, c, d, e, f]: where a x^2 + b x y + c y^2 + d x + e y + f >= 0.", Status::works,
     any_range, "2D"},
    {"geometry.shapes.*.quadric", numbers_value, alternative,
     "Ten numbers, the coefficients of x^2, y^2, z^2, x y, x z, y z, x, y, z and 1: where their "
     "sum "
     "is >= 0.",
     Status::works, any_range, "3D"},
    {"geometry.shapes.*.expression", expression_value, alternative,
     "The points where a formula is >= 0."},
    {"geometry.shapes.*.enclosed_by", list_value, alternative,
     "What closed curves of segments and arcs enclose (in space, surfaces of triangles), given as "
     "a "
     "list of sets; sides are named after them. Where their own curves do not tell inside from "
     "outside, separators are added: see check.",
     Status::works, any_range, "2D 3D"},
    {"geometry.shapes.*.enclosed_by[]", name_value, required, "A set."},
    {"geometry.shapes.*.combine", shapes_value, alternative,
     "A Boolean expression of other shapes, as a shape."},
    {"geometry.shapes.*.transform", map_value, alternative,
     "A shape scaled, turned and moved, in this order; sides those of the shape."},
    {"geometry.shapes.*.transform.of", name_value, required, "The shape."},
    {"geometry.shapes.*.transform.scale", number_value, standard("1"), "A factor.", Status::works,
     positive},
    {"geometry.shapes.*.transform.rotate", number_value | map_value, standard("0"),
     "An angle in degrees, counter-clockwise, or in space {axis, angle}."},
    {"geometry.shapes.*.transform.rotate.axis", point, required, "The axis of the rotation."},
    {"geometry.shapes.*.transform.rotate.angle", number_value, required,
     "The angle of the rotation, in degrees."},
    {"geometry.shapes.*.transform.translate", number_value | point, standard("0"), "A vector."},
    {"geometry.shapes.*.transform.about", name_value | point, standard("origin"),
     "The point that scaling and turning keep."},
    {"geometry.shapes.*.offset", map_value, alternative,
     "The points within a distance of a shape; negative: erosion.", later},
    {"geometry.shapes.*.offset.of", name_value, required, "The shape."},
    {"geometry.shapes.*.offset.distance", number_value, required, "The distance."},
    {"geometry.shapes.*.minkowski_sum", list_value, alternative,
     "The sums of points of two shapes.", later},
    {"geometry.shapes.*.blend", map_value, alternative, "Two shapes joined with a rounding.",
     later},
    {"geometry.shapes.*.blend.a", name_value, required, "The first shape."},
    {"geometry.shapes.*.blend.b", name_value, required, "The second shape."},
    {"geometry.shapes.*.blend.operation", word_value, required, "How they are joined."},
    {"geometry.shapes.*.blend.operation=union", word_value, optional, "Points of either."},
    {"geometry.shapes.*.blend.operation=intersection", word_value, optional, "Points of both."},
    {"geometry.shapes.*.blend.operation=difference", word_value, optional, "Points of a, not b."},
    {"geometry.shapes.*.blend.radius", number_value, required, "The radius of the rounding.", later,
     positive},
    {"geometry.shapes.*.pattern", map_value, alternative, "Copies of a shape.", later},

    {"geometry.profiles", named_map_value, optional,
     "Plane shapes for extrusion and revolution, a map like shapes.", Status::works, any_range,
     "3D"},
    {"geometry.profiles.*", map_value, required, "One plane shape."},

    {"geometry.domain", shapes_value, required,
     "The domain: a Boolean expression of shapes with & (and), | (or), - (minus), ! (not), "
     "^ (exclusive or) and parentheses."},
    {"geometry.combine", map_value, standard("{}"),
     "How the Boolean expression becomes the function that multiplies the unknown."},
    {"geometry.combine.rule", word_value, standard("auto"), "The rule."},
    {"geometry.combine.rule=auto", word_value, optional,
     "Products where boundaries do not meet or meet at right angles, R0-functions elsewhere."},
    {"geometry.combine.rule=R0", word_value, optional, "R0-functions: a + b - sqrt(a^2 + b^2)."},
    {"geometry.combine.rule=R1", word_value, optional, "Minimum and maximum."},
    {"geometry.combine.rule=product", word_value, optional, "Products."},
    {"geometry.combine.rule=Ralpha", word_value, optional,
     "R-functions (a + b - sqrt(a^2 + b^2 - 2 alpha a b)) / (1 + alpha)."},
    {"geometry.combine.rule=Rp", word_value, optional, "R-functions a + b - (a^p + b^p)^(1/p)."},
    {"geometry.combine.rule=R0m", word_value, optional,
     "R0-functions times (a^2 + b^2)^(m/2): m times differentiable, not normalised."},
    {"geometry.combine.rule=plateau", word_value, optional,
     "As auto, with factors that are constant beyond a distance from the boundary."},
    {"geometry.combine.alpha", number_value, required, "The parameter of Ralpha.", Status::works,
     Range{-1, 1, true}, "Ralpha"},
    {"geometry.combine.p", integer_value, required, "The exponent of Rp, even.", Status::works,
     between(2, 64), "Rp"},
    {"geometry.combine.m", integer_value, required, "The smoothness of R0m.", Status::works,
     between(1, 16), "R0m"},
    {"geometry.combine.width", number_value, required, "The width of the slope of plateau.",
     Status::works, positive, "plateau"},
    {"geometry.combine.power", integer_value, standard("3"),
     "The plateau is power - 1 times differentiable.", Status::works, between(1, 16), "plateau"},
    {"geometry.combine.corner_scales", named_map_value, optional,
     "Scales by name: of a piece or shape (its function is divided by the scale), or of a corner "
     "written \"a & b\" (the weight is joined with the distance from it over the scale)."},
    {"geometry.combine.corner_scales.*", number_value, required, "The scale.", Status::works,
     positive},
    {"geometry.combine.saturate", map_value, optional,
     "The functions of shapes f become f / (1 + |beta f|^alpha), which is bounded."},
    {"geometry.combine.saturate.alpha", number_value, standard("2"), "The exponent.", Status::works,
     at_least(1)},
    {"geometry.combine.saturate.beta", number_value, required, "One over a length.", Status::works,
     positive},
    {"geometry.combine.cap", expression_value, optional,
     "The functions of shapes are joined with this formula by R0-conjunction: below it, and "
     "unchanged at the boundary. Positive in the domain."},
    {"geometry.bounds", map_value, optional,
     "A box that contains the domain; needed only where it cannot be found from the domain."},
    {"geometry.bounds.min", point, required, "The corner with the smallest coordinates."},
    {"geometry.bounds.max", point, required, "The corner with the largest coordinates."},
});

}  // namespace

std::span<const SchemaRow> geometry_rows() { return rows; }

}  // namespace rfm
