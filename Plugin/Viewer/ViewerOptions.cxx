// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerOptions.h"

#include "ToolSpecification.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace palpate
{
namespace
{
const char* const Footer =
  R"(Units: mm, N, MPa, s. Tools: flat:R, sphere:R, paraboloid:R, cone:DEGREES (from the axis),
truncated:R,DEGREES (R: of the flat), blunted:R,DEGREES (R: of the tip), rounded:R,EDGE, power:EXPONENT,COEFFICIENT,
profile:FILE.csv (a line r_mm,f_mm per point, from 0,0 outward).

Files: .palpate (written by --export), .vtp .stl .ply .obj .vtk (surfaces), .vtu (volume meshes: their surface is taken),
.nii .nii.gz .vti (scans: their outer skin is taken).

Examples:
  palpate                                    the head of Debian's mricron-data, three tools
  palpate --scene cylinder                   the scene of Mahvash and Hayward 2002, Figure 9
  palpate liver.stl --tool sphere:6.35 --young 0.05 --poisson 0.45
  palpate liver.stl --measured press.csv --tool sphere:1.6   felt with another tool than measured
  palpate liver.stl --tool sphere:6.35 --voxel 2 --fixed z-   as a solid that lies on its lowest side
  palpate liver.stl --layer 10               as a layer of 10 mm on a rigid base
  palpate --window                           the head in a window, under the mouse
  palpate phantom.obj --length-unit m --site 0,0,1 --slide-to 0.3,0,1 --depth 1.5)";

/// NaN and infinity are numbers to CLI11 and pass its ranges.
std::string checkFinite(const std::string& text)
{
  return std::isfinite(std::strtod(text.c_str(), nullptr)) ? std::string()
                                                           : text + " is not a finite number";
}

/// --layer: "scan", "none" or a thickness.
std::optional<LayerChoice> readLayer(const std::string& text)
{
  if (text == "scan" || text == "none")
  {
    return LayerChoice{ text == "scan", 0.0 };
  }
  char* end = nullptr;
  const double thickness = std::strtod(text.c_str(), &end);
  const bool good = !text.empty() && !*end && std::isfinite(thickness) && thickness > 0.0;
  return good ? std::optional<LayerChoice>({ false, thickness }) : std::nullopt;
}

std::string checkLayer(const std::string& text)
{
  return readLayer(text) ? std::string()
                         : "'" + text + "' is neither scan nor none nor a thickness in mm, > 0";
}

/// As vtkVoxelBody takes them.
std::string checkFaces(const std::string& text)
{
  const std::vector<std::string> known = { "x-", "x+", "y-", "y+", "z-", "z+" };
  for (const std::string& face : CLI::detail::split(text, ','))
  {
    if (std::find(known.begin(), known.end(), face) == known.end())
    {
      return "'" + face + "' is not one of x-, x+, y-, y+, z-, z+";
    }
  }
  return {};
}

/// How the contact feels: names for the numbers of GivenSettings.
void addContactOptions(CLI::App& app, GivenSettings& contact)
{
  using Names = std::map<std::string, int>;
  const Names forms = { { "paper", 0 }, { "normalized", 1 }, { "energy", 2 } };
  const Names surfaces = { { "facets", 0 }, { "smooth", 1 } };
  const Names models = { { "elasto-plastic", 0 }, { "dahl", 1 }, { "shape", 2 } };
  const auto add = [&app](const char* option, int& value, const char* what, const Names& names)
  {
    std::string usual;
    for (const auto& [name, number] : names)
    {
      usual = number == value ? name : usual;
    }
    app
      .add_option_function<std::string>(
        option, [&value, names](const std::string& name) { value = names.at(name); }, what)
      ->check(CLI::IsMember(names))
      ->default_str(usual);
  };
  app
    .add_option(
      "--friction", contact.frictionCoefficient, "Coulomb's coefficient of friction; 0: none")
    ->check(CLI::NonNegativeNumber)
    ->capture_default_str();
  add("--friction-model", contact.frictionModel,
    "what a contact does before it slides: elasto-plastic (sticks), dahl (creeps), or what shape "
    "and "
    "depth of the contact tell",
    models);
  app
    .add_option("--tangential-stiffness", contact.tangentialStiffness,
      "of the stuck contact, N/mm; not for --friction-model shape")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  add("--force-form", contact.forceForm,
    "how the curves at a triangle's corners become one force: as the paper prints it, with the "
    "direction normalized, or so that closed loops neither gain nor lose energy",
    forms);
  add("--contact-surface", contact.contactSurface,
    "what the tip touches: the triangles, or smooth patches through their normals", surfaces);
}

std::string checkToolText(const std::string& text)
{
  ToolSpecification tool;
  std::string error;
  return parseTool(text, tool, error) ? std::string() : error;
}
} // namespace

std::optional<int> readCommandLine(int argc, char** argv, ViewerOptions& options)
{
  CLI::App app{ "Press a tool against a body, see and feel the force.", "palpate" };
  app.footer(Footer);
  app.set_version_flag("--version", PALPATE_VERSION);
  const std::map<std::string, double> units = { { "mm", 1.0 }, { "cm", 10.0 }, { "m", 1000.0 } };
  std::array<double, 3> site{};
  std::array<double, 3> slideTo{};
  std::string layer;

  app.add_option("BODY", options.body, "the body to touch; without one, the --scene");
  app.add_option("--scene", options.scene, "a scene of its own")
    ->check(CLI::IsMember({ "head", "cylinder" }))
    ->capture_default_str();
  app.add_option("--scan", options.scan, "scan of the head scene (default: mricron-data's ch2)");
  app
    .add_option("--tool", options.tools,
      "a tool; give several to compare their curves, the first one touches")
    ->check(CLI::Validator(checkToolText, "SHAPE:SIZE"));
  app.add_option("--young", options.youngsModulus, "Young's modulus of the body, MPa")
    ->check(CLI::PositiveNumber);
  app.add_option("--poisson", options.poissonsRatio, "Poisson's ratio of the body")
    ->check(CLI::Range(0.0, 0.5));
  app.add_option("--depth", options.depth, "depth the tip is pressed to, mm")
    ->check(CLI::PositiveNumber);
  app.add_option("--max-deflection", options.maximumDeflection, "depth the responses reach, mm")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  app
    .add_option("--measured", options.measured,
      "curves measured on the body, a .csv; the tools follow from what they show. Give several for "
      "several tools")
    ->excludes("--young");
  app
    .add_option("--register", options.registration,
      "carries the frame of the curves to the body's: a 4x4 matrix, or a .csv of pairs of points")
    ->needs("--measured");
  app.add_option("--reach", options.reach, "how far a measured site speaks for, mm")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  app
    .add_option("--voxel", options.voxel,
      "fill the closed surface with hexahedra of this side, mm: each point then also gives way "
      "with "
      "the body as a whole")
    ->check(CLI::PositiveNumber)
    ->excludes("--measured");
  app
    .add_option("--fixed", options.fixedFaces,
      "sides of the bounding box that hold the filled body: x-,x+,y-,y+,z-,z+")
    ->check(CLI::Validator(checkFaces, "SIDES"))
    ->needs("--voxel")
    ->capture_default_str();
  app
    .add_option("--layer", layer,
      "soft tissue on a rigid base: scan (as thick as the scan of the body shows; the head's "
      "default), none (a half-space), or its thickness everywhere, mm")
    ->check(CLI::Validator(checkLayer, "scan|none|MM"))
    ->excludes("--measured")
    ->excludes("--voxel");
  app.add_option("--base", options.baseValue, "grey level below which a scan is bone")
    ->capture_default_str();
  app.add_option("--length-unit", options.lengthScale, "unit of length of the file: mm, cm or m")
    ->transform(CLI::Transformer(units))
    ->default_str("mm");
  app
    .add_option("--resolution", options.resolution,
      "distance of the vertices taken from a scan, mm; 0: the scan's own")
    ->check(CLI::NonNegativeNumber)
    ->capture_default_str();
  app.add_option("--contour", options.contourValue, "grey level of the skin in a scan")
    ->capture_default_str();
  app
    .add_option(
      "--closing", options.closingRadius, "openings of a scan's skin up to twice this are shut, mm")
    ->check(CLI::NonNegativeNumber)
    ->capture_default_str();
  app.add_option("--site", site, "where to press: a direction from the middle of the body, X,Y,Z")
    ->delimiter(',');
  app.add_option("--slide-to", slideTo, "where to slide to, likewise")->delimiter(',');
  app.add_option("--rate", options.rate, "ticks per second of virtual time")
    ->check(CLI::Range(1.0, 100000.0))
    ->capture_default_str();
  addContactOptions(app, options.contact);
  app.add_option("--output", options.output, "folder for pictures and trajectory")
    ->capture_default_str();
  app.add_option("--save", options.save, "also write the body with its responses, a .vtp");
  app.add_option("--export", options.exportTo,
    "also write the body with the first tool's responses for loops without VTK, a .palpate");
  app.add_flag("--window", options.window,
    "open a window in which the mouse moves the tool, instead of writing pictures");
  app.add_option("--screenshot", options.screenshot,
    "with --window: a picture of the window as it was when it closed, a .png");

  for (const char* option : { "--young", "--poisson", "--depth", "--max-deflection",
         "--length-unit", "--resolution", "--contour", "--closing", "--base", "--reach", "--voxel",
         "--site", "--slide-to", "--rate", "--friction", "--tangential-stiffness" })
  {
    app.get_option(option)->check(CLI::Validator(checkFinite, ""));
  }

  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error);
  }
  if (app.count("--site") > 0)
  {
    options.site = site;
  }
  if (app.count("--layer") > 0)
  {
    options.layer = readLayer(layer);
  }
  if (app.count("--slide-to") > 0)
  {
    options.slideTo = slideTo;
  }
  return std::nullopt;
}
} // namespace palpate
