#include <rfm/core/evaluate.hpp>
#include <rfm/core/primitives.hpp>

// The normalised function of a circle of radius 2 at distance 1 from its centre: (4 − 1) / 4.
int main() {
  const rfm::Region disk = rfm::circle({1, 1}, 2);
  return rfm::value_at(disk.primitives()[0]->function, {2, 1}) == 0.75 ? 0 : 1;
}
