#include "problems/output/text.hpp"

// Before VTK 9.2 only the deprecated string type reads UTF-8: of a plain string all letters but
// ASCII are lost.
#define VTK_DEPRECATION_LEVEL 0
#include <vtkFreeTypeTools.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkVersionMacros.h>
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
#include <vtkUnicodeString.h>
#else
#include <vtkStdString.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "core/error.hpp"

#ifndef RFM_FONT_FILE
#define RFM_FONT_FILE ""
#endif

namespace rfm {
namespace {

// Length of the UTF-8 character at the beginning of `text`; 0 if it is none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  return length;
}

// What VTK's own font lacks, in letters that it has.
constexpr std::array<std::pair<std::string_view, std::string_view>, 45> spelled = {{
    {"α", "alpha"}, {"β", "beta"},  {"γ", "gamma"},    {"δ", "delta"}, {"ε", "epsilon"},
    {"ζ", "zeta"},  {"η", "eta"},   {"θ", "theta"},    {"κ", "kappa"}, {"λ", "lambda"},
    {"μ", "mu"},    {"ν", "nu"},    {"ξ", "xi"},       {"π", "pi"},    {"ρ", "rho"},
    {"σ", "sigma"}, {"τ", "tau"},   {"φ", "phi"},      {"χ", "chi"},   {"ψ", "psi"},
    {"ω", "omega"}, {"Γ", "Gamma"}, {"Δ", "Delta"},    {"Θ", "Theta"}, {"Λ", "Lambda"},
    {"Π", "Pi"},    {"Σ", "Sigma"}, {"Φ", "Phi"},      {"Ψ", "Psi"},   {"Ω", "Omega"},
    {"∂", "d"},     {"∇", "grad "}, {"−", "-"},        {"–", "-"},     {"—", "-"},
    {"·", "."},     {"×", "x"},     {"→", "->"},       {"≤", "<="},    {"≥", ">="},
    {"≈", "~"},     {"…", "..."},   {"∞", "infinity"}, {"√", "sqrt"},  {"°", " deg"},
}};

const std::string& font_file() {
  static const std::string file = [] {
    std::error_code ignored;
    return std::filesystem::exists(RFM_FONT_FILE, ignored) ? RFM_FONT_FILE : "";
  }();
  return file;
}

std::string printable(const std::string& text) {
  std::string result;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t length = character_length(rest);
    const std::string_view character = rest.substr(0, length);
    rest.remove_prefix(std::max<std::size_t>(length, 1));
    if (length == 0) continue;
    if (length == 1 && static_cast<unsigned char>(character[0]) < 0x20) {
      result += ' ';
      continue;
    }
    const auto known =
        font_file().empty()
            ? std::ranges::find(spelled, character, [](const auto& s) { return s.first; })
            : spelled.end();
    result += known != spelled.end() ? known->second : character;
  }
  return result;
}

}  // namespace

TextImage render_text(const std::string& text, double size) {
  const std::string content = printable(text);
  TextImage result;
  if (content.find_first_not_of(' ') == std::string::npos) return result;
  vtkNew<vtkTextProperty> style;
  style->SetFontSize(std::max(1, static_cast<int>(std::lround(size))));
  if (!font_file().empty()) {
    style->SetFontFamily(VTK_FONT_FILE);
    style->SetFontFile(font_file().c_str());
  } else {
    style->SetFontFamilyToArial();
  }
  style->SetColor(1, 1, 1);
  constexpr int points_are_pixels = 72;
  vtkFreeTypeTools* tools = vtkFreeTypeTools::GetInstance();
  tools->ScaleToPowerTwoOff();
  vtkNew<vtkImageData> image;
  vtkTextRenderer::Metrics metrics;
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
  const vtkUnicodeString string = vtkUnicodeString::from_utf8(content);
#else
  const vtkStdString string(content);
#endif
  if (!tools->RenderString(style, string, points_are_pixels, image) ||
      !tools->GetMetrics(style, string, points_are_pixels, metrics))
    throw ComputationError("cannot draw the text '" + content + "'");
  int dimensions[3];
  image->GetDimensions(dimensions);
  Coverage& coverage = result.coverage;
  coverage.width = dimensions[0];
  coverage.height = dimensions[1];
  coverage.amount.resize(static_cast<std::size_t>(coverage.width) * coverage.height);
  const int components = image->GetNumberOfScalarComponents();
  const auto* bytes = static_cast<const unsigned char*>(image->GetScalarPointer());
  for (int y = 0; y < coverage.height; ++y)  // VTK counts rows from below
    for (int x = 0; x < coverage.width; ++x)
      coverage.amount[static_cast<std::size_t>(coverage.height - 1 - y) * coverage.width + x] =
          static_cast<float>(bytes[components * (y * coverage.width + x) + components - 1] / 255.0);
  result.ascent = coverage.height + metrics.Descent[1];  // downwards is negative
  return result;
}

Coverage turned_upwards(const Coverage& coverage) {
  Coverage turned{coverage.left, coverage.top, coverage.height, coverage.width, {}};
  turned.amount.resize(coverage.amount.size());
  for (int y = 0; y < coverage.height; ++y)
    for (int x = 0; x < coverage.width; ++x)
      turned.amount[static_cast<std::size_t>(coverage.width - 1 - x) * turned.width + y] =
          coverage.amount[static_cast<std::size_t>(y) * coverage.width + x];
  return turned;
}

}  // namespace rfm
