#pragma once

#include "problems/output/canvas.hpp"
#include "problems/output/pixel_window.hpp"
#include "problems/pictures/scene_samples.hpp"
#include "quadrature/domain_rule.hpp"

namespace rfm {

/// Paints a dot for each point of a plane rule, grey inside and dark on the boundary and on
/// interfaces, into a window whose upper left corner is at pixel (left, top).
void paint_rule_dots(Canvas& canvas, double left, double top, const PixelWindow& window,
                     const DomainRule& rule);

/// Of a rule in space, the points of the boundary that are seen.
void paint_rule_dots(Canvas& canvas, double left, double top, const SceneSamples& scene,
                     const Camera& camera, const DomainRule& rule);

}  // namespace rfm
