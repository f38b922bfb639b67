// SPDX-License-Identifier: BSD-3-Clause
#include "TissueOptions.h"

#include "ContactNames.h"
#include "Mechanics/Checked.h"
#include "Mechanics/JoinedText.h"
#include "NumberRange.h"
#include "TissueChoice.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace palpate
{
namespace
{
/// The largest Poisson's ratio that the finite elements permit.
constexpr double LargestTissueRatio = 0.499;
} // namespace

std::string readTissue(const std::string& text, TissueChoice& tissue)
{
  const std::vector<std::string> parts = CLI::detail::split(text, ':');
  if (parts.size() != 3)
  {
    return "'" + text.substr(0, 40) + "' is not LABEL:MPA:NU, e.g. 1:0.006:0.49";
  }
  TissueChoice read;
  std::string fault = firstFault([&]
    { return NumberRange::any("a label of the image, e.g. 1").read(parts[0], read.label); },
    [&] { return YoungsModulusRange.read(parts[1], read.youngsModulus); },
    [&]
    {
      return NumberRange::between(
        0.0, LargestTissueRatio, "Poisson's ratio of a tissue, 0 to 0.499, e.g. 0.49")
        .read(parts[2], read.poissonRatio);
    });
  if (fault.empty())
  {
    tissue = read;
  }
  return fault;
}

void addTissueOptions(CLI::App& app, ViewerOptions& options)
{
  CLI::Option* tissue =
    app
      .add_option_function<std::vector<std::string>>(
        "--tissue",
        [&options](const std::vector<std::string>& texts)
        {
          options.tissues.resize(texts.size());
          for (std::size_t i = 0; i < texts.size(); ++i)
          {
            readTissue(texts[i], options.tissues[i]);
          }
        },
        "BODY is an image of labels: the voxels with this label have this modulus, MPa, and this "
        "Poisson's ratio. Give it once for each tissue; voxels with other labels are empty. The "
        "tissues are filled with tetrahedra and solved, and a window shows the map of the force at "
        "--depth. With --output, --save, --export, --no-pictures or another display: that instead")
      ->check(CLI::Validator(
        [](const std::string& text)
        {
          TissueChoice ignored;
          return readTissue(text, ignored);
        },
        "LABEL:MPA:NU"))
      ->allow_extra_args(false)
      ->needs("BODY");
  for (const char* option :
    { "--scene", "--scan", "--young", "--poisson", "--measured", "--voxel", "--layer", "--layers",
      "--contour", "--closing", "--base", "--resolution", "--length-unit", "--compare", "--trial" })
  {
    tissue->excludes(app.get_option(option));
  }
}

void checkTissues(const CLI::App& app, ViewerOptions& options)
{
  for (std::size_t i = 0; i < options.tissues.size(); ++i)
  {
    const double label = options.tissues[i].label;
    const auto end = options.tissues.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::any_of(options.tissues.begin(), end,
          [label](const TissueChoice& other) { return other.label == label; }))
    {
      throw CLI::ValidationError("--tissue", joined("label ", label, " has two tissues"));
    }
  }
  const auto isGiven = [&app](const char* option) { return app.count(option) > 0; };
  constexpr std::array<const char*, 8> others = { "--output", "--save", "--export", "--pictures",
    "--window", "--map", "--device", "--record" };
  if (!options.tissues.empty() && std::none_of(others.begin(), others.end(), isGiven))
  {
    options.window = true;
    options.map = true;
  }
}
} // namespace palpate
