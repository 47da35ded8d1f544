#include "core/even_and_odd.hpp"

#include <algorithm>

#include "core/composition.hpp"
#include "core/field_node.hpp"
#include "core/graph_walk.hpp"

namespace rfm {
namespace {

using Parts = EvenAndOddParts;
using Known = std::optional<Parts>;

class Splitter {
 public:
  Splitter(const Field& square, const Field& height) : square_(square), height_(height) {}

  Known leaf(const Field& field) const {
    const Field::Node& node = field.node();
    if (node.operation == Operation::source) return {};
    if (node.operation != Operation::coordinate) return Parts{field, 0.0};
    if (node.index == 0) return Parts{0.0, 1.0};
    return Parts{node.index == 1 ? height_ : field, 0.0};
  }

  Known inner(const Field& field, const std::vector<Known>& arguments) const {
    if (!std::ranges::all_of(arguments, [](const Known& part) { return part.has_value(); }))
      return {};
    const Parts &a = *arguments[0], &b = arguments.size() > 1 ? *arguments[1] : a;
    switch (field.node().operation) {
      case Operation::add:
        return Parts{a.even + b.even, a.odd + b.odd};
      case Operation::subtract:
        return Parts{a.even - b.even, a.odd - b.odd};
      case Operation::negate:
        return Parts{-a.even, -a.odd};
      case Operation::multiply:
        return product(a, b);
      case Operation::divide:
        if (b.is_even()) return Parts{a.even / b.even, a.is_even() ? Field(0.0) : a.odd / b.even};
        return {};
      case Operation::integer_power:
        if (const Known whole = power(a, field.node().number)) return whole;
        break;
      case Operation::abs:
        if (a.even.is_constant(0)) return Parts{0.0, abs(a.odd)};
        break;
      case Operation::hypot: {
        const Parts sum{product(a, a).even + product(b, b).even,
                        product(a, a).odd + product(b, b).odd};
        if (sum.is_even() && !(a.is_even() && b.is_even())) return Parts{sqrt(sum.even), 0.0};
        break;
      }
      default:
        break;
    }
    std::vector<Field> even;
    for (const Known& part : arguments) {
      if (!part->is_even()) return {};
      even.push_back(part->even);
    }
    return Parts{with_arguments(field, std::move(even)), 0.0};
  }

 private:
  // A part that is zero stays so beside one that is not defined everywhere: the other part of the
  // product is not defined there either.
  static Field times(const Field& a, const Field& b) {
    return a.is_constant(0) || b.is_constant(0) ? Field(0.0) : a * b;
  }
  Parts product(const Parts& a, const Parts& b) const {
    return {times(a.even, b.even) + times(square_, times(a.odd, b.odd)),
            times(a.even, b.odd) + times(a.odd, b.even)};
  }
  // By repeated multiplication where there is an odd part.
  Known power(const Parts& a, double exponent) const {
    constexpr double largest = 64;
    if (a.is_even() || exponent < 1 || exponent > largest) return {};
    const int n = static_cast<int>(exponent);
    if (a.even.is_constant(0)) {
      const Field whole = pow(square_, n / 2.0 - (n % 2) / 2.0) * pow(a.odd, n);
      return n % 2 == 0 ? Parts{whole, 0.0} : Parts{0.0, whole};
    }
    Parts result = a;
    for (int i = 1; i < n; ++i) result = product(result, a);
    return result;
  }

  Field square_, height_;
};

}  // namespace

std::optional<EvenAndOddParts> even_and_odd(const Field& f, const Field& square,
                                            const Field& height) {
  const Splitter splitter(square, height);
  return walked<Known>(
      without_partials(f), [&](const Field& field) { return splitter.leaf(field); },
      [&](const Field& field, const std::vector<Known>& arguments) {
        return splitter.inner(field, arguments);
      });
}

}  // namespace rfm
