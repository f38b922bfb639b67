// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerOptions.h"

#include "OptionChecks.h"
#include "SessionOptions.h"
#include "TissueOptions.h"
#include "TrialOptions.h"
#include "ViewerFooter.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace palpate
{
namespace
{
constexpr double LargestDepth = 1000.0; // mm; a press to a larger depth would take minutes

/// Adds the options of the views that show something other than one tool on one body.
void addViewOptions(CLI::App& app, ViewerOptions& options)
{
  CLI::Option* compare = app.add_flag("--compare", options.compare,
    "two bodies of rubber side by side under the same tools and motion: a strip on rollers, which "
    "bends, and a block on a plate, which only dents; curves and verdict below each");
  for (const char* option : { "BODY", "--scene", "--scan", "--measured", "--voxel", "--solid",
         "--layer", "--layers", "--site", "--slide-to", "--length-unit", "--resolution", "--save",
         "--export", "--device", "--hand", "--record", "--trial", "--pictures" })
  {
    compare->excludes(app.get_option(option));
  }
  CLI::Option* map = app.add_flag("--map", options.map,
    "draw where on the body the shape of the first tool matters at --depth: regime index, "
    "sensitivity and verdict as colours; with --window the body can be turned; with --tissue the "
    "force");
  for (const char* option :
    { "--measured", "--device", "--hand", "--record", "--trial", "--compare", "--pictures" })
  {
    map->excludes(app.get_option(option));
  }
}
} // namespace

std::optional<int> readCommandLine(int argc, char** argv, ViewerOptions& options)
{
  CLI::App app{ "Press a tool against a body, see and feel the force.", "palpate" };
  app.footer(ViewerFooter);
  app.set_version_flag("--version", PALPATE_VERSION);
  std::array<double, 3> site{};
  std::array<double, 3> slideTo{};
  std::string layer;
  std::string layers;
  std::string alternatives;

  app.add_option("BODY", options.body, "the body to touch; without one, the --scene");
  app.add_option("--scene", options.scene, "a built-in scene")
    ->check(CLI::IsMember({ "head", "cylinder", "phantom" }))
    ->capture_default_str();
  app.add_option("--scan", options.scan, "scan of the head scene (default: mricron-data's ch2)");
  app
    .add_option("--tool", options.tools,
      "a tool (for BODY sphere:5 by default); with several tools their curves are compared, and "
      "the "
      "first one touches the body")
    ->check(CLI::Validator(checkToolText, "SHAPE:SIZE"));
  app
    .add_option("--young", options.youngsModulus,
      "Young's modulus of the body, MPa (for BODY 0.1 by default)")
    ->check(within(YoungsModulusRange, "POSITIVE"));
  app
    .add_option(
      "--poisson", options.poissonRatio, "Poisson's ratio of the body (for BODY 0.45 by default)")
    ->check(within(PoissonsRatioRange, "0 TO 0.5"));
  app.add_option("--depth", options.depth, "depth to which the tip is pressed, mm")
    ->check(positive("a depth in mm, e.g. 1", LargestDepth));
  app
    .add_option(
      "--max-deflection", options.maximumDeflection, "depth of the responses' last sample, mm")
    ->check(positive("a depth in mm, e.g. 2", Kilometre))
    ->capture_default_str();
  app
    .add_option("--measured", options.measured,
      "curves measured on the body, a .csv; the responses of the tools are made from them. Give "
      "one file for each measuring tool")
    ->excludes("--young");
  app
    .add_option("--register", options.registration,
      "transforms the frame of the curves to that of the body: a 4x4 matrix, or a .csv of pairs of "
      "points")
    ->needs("--measured");
  app.add_option("--reach", options.reach, "distance within which a measured site is used, mm")
    ->check(positive("a distance in mm, e.g. 20", Kilometre))
    ->capture_default_str();
  app
    .add_option("--max-strain", options.maximumStrain,
      "largest ratio of contact radius to tip radius for which readings of --measured are used")
    ->check(positive("a fraction, e.g. 0.4"))
    ->needs("--measured")
    ->capture_default_str();
  app
    .add_option("--voxel", options.voxel,
      "fill the closed surface with hexahedra of this size, mm: the responses then include the "
      "deflection of the whole body")
    ->check(positive("the side of a voxel in mm, e.g. 2", Kilometre))
    ->excludes("--measured");
  app
    .add_option_function<std::string>(
      "--solid",
      [&options](const std::string& text)
      {
        options.solid = true;
        readSolid(text, options.solidSpacing);
      },
      "fill the closed surface with tetrahedra of this size at the surface, mm, larger inside "
      "(without a number: chosen from body and tools): the responses are then those of the body's "
      "true shape; with --tissue: the size of its tetrahedra")
    ->expected(0, 1)
    ->check(CLI::Validator(
      [](const std::string& text)
      {
        double ignored = 0.0;
        return readSolid(text, ignored);
      },
      "MM"))
    ->excludes("--voxel")
    ->excludes("--measured");
  app
    .add_option("--fixed", options.fixedFaces,
      "sides of the bounding box at which the body is held: x-,x+,y-,y+,z-,z+, each with its depth "
      "in mm if that is not half a cell, as in z-:5; without --solid and --voxel the side on which "
      "the body stands best is the default")
    ->check(CLI::Validator(checkFaces, "SIDES"))
    ->capture_default_str();
  app
    .add_flag("--no-whole-body{false}", options.wholeBody,
      "leave out the deflection of the body as a whole, which the responses include for a closed "
      "body without layers")
    ->disable_flag_override();
  app
    .add_option("--layer", layer,
      "soft tissue on a rigid base: scan (thickness from the scan of the body; the head's "
      "default), none (a half-space), or one thickness everywhere, mm")
    ->check(CLI::Validator(
      [](const std::string& text)
      {
        LayerChoice ignored;
        return readLayer(text, ignored);
      },
      "scan|none|MM"))
    ->excludes("--measured")
    ->excludes("--solid")
    ->excludes("--voxel");
  app
    .add_option("--layers", layers,
      "layers on each other, outermost first, on a rigid base: MM:MPA:NU,MM:MPA:NU,...; 0 mm in "
      "the last one: an elastic half-space; scan in place of the mm of one of two layers: the "
      "scan's soft tissue minus the other layer; :slip after a layer: it slips without friction "
      "below the layer above; ,slip at the end: the lowest layer slips on the rigid base. scan "
      "alone: skin over fat")
    ->check(CLI::Validator(
      [](const std::string& text)
      {
        LayerChoice ignored;
        return readLayers(text, ignored);
      },
      "scan|MM:MPA:NU,..."))
    ->excludes("--layer")
    ->excludes("--measured")
    ->excludes("--solid")
    ->excludes("--voxel")
    ->excludes("--young")
    ->excludes("--poisson");
  app
    .add_option_function<std::string>(
      "--strain", [&options](const std::string& text) { readStrain(text, options.terms); },
      "law of the body at large strain: small (the laws of small strain), neo-hooke, ogden:ALPHA "
      "or demiray:B (solved once, in about a minute, and stored); auto: neo-hooke if a table has "
      "the tool; it, curvature and layers are left out if they change the force by less than "
      "--tolerance, and the per cent of each is reported (the head's default; for a --solid: "
      "neo-hooke if a table has the tool)")
    ->check(CLI::Validator(
      [](const std::string& text)
      {
        LawTerms ignored;
        return readStrain(text, ignored);
      },
      "LAW"))
    ->excludes("--measured")
    ->default_str("small");
  app
    .add_option("--error-tolerance", options.terms.errorTolerance,
      "estimated relative error of the force up to which curves are drawn in full; 0: they are "
      "drawn in full until the first assumption of the law fails, and no error is given")
    ->check(notNegative("a relative error, e.g. 0.05"))
    ->excludes("--measured")
    ->capture_default_str();
  app
    .add_flag("--curvature,!--no-curvature", options.terms.curvature,
      "include the body's curvature under the tool (default; --no-curvature: the body counts as "
      "flat)")
    ->disable_flag_override();
  app
    .add_flag("--edges", options.terms.edges,
      "include sharp edges: a contact near an edge is softer, and its force falls to zero without "
      "a jump as it leaves over the edge")
    ->excludes("--measured")
    ->disable_flag_override();
  app
    .add_option("--tilt", options.terms.tilt,
      "largest tilt of the tool against the body's normal, in degrees: force and torque follow the "
      "tilt; 0: the tool counts as upright")
    ->check(any("an angle in degrees, e.g. 30"))
    ->capture_default_str();
  app
    .add_option_function<std::string>(
      "--relax",
      [&options](const std::string& text) { parsePronySeries(text, options.relaxation); },
      "relaxation of the body: strength:seconds,... of up to four branches, as in 0.5:0.1,0.3:2; a "
      "strength is relative to the slow response, to which the modulus belongs. A fast press is up "
      "to 1 + the sum of the strengths times as stiff")
    ->check(CLI::Validator(
      [](const std::string& text)
      {
        PronySeries ignored;
        return text.empty() ? std::string("no relaxation is given, e.g. 0.5:0.1,0.3:2")
                            : parsePronySeries(text, ignored);
      },
      "P:S,..."))
    ->excludes("--measured");
  app.add_option("--base", options.baseValue, "grey level below which a scan is bone")
    ->check(any("a grey level, e.g. 35"))
    ->capture_default_str();
  app.add_option("--length-unit", options.lengthScale, "unit of length of the file: mm, cm or m")
    ->transform(CLI::Validator(readLengthUnit, "mm|cm|m"))
    ->default_str("mm");
  app
    .add_option("--resolution", options.resolution,
      "distance between the vertices of a scan's surface, mm; 0: that of the scan's voxels")
    ->check(notNegative("a distance in mm, e.g. 2; 0: the scan's own"))
    ->capture_default_str();
  app
    .add_option("--contour", options.contourValue,
      "grey level of the skin in a scan; 0: chosen from the scan (the head's default is 30)")
    ->check(any("a grey level, e.g. 30; 0: chosen"))
    ->capture_default_str();
  app
    .add_option("--closing", options.closingRadius,
      "openings of a scan's skin up to twice this width are closed, mm")
    ->check(within(
      NumberRange::between(0.0, 100.0, "a radius in mm, e.g. 6; 0: none is closed"), "0 TO 100"))
    ->capture_default_str();
  app.add_option("--site", site, "place to press: a direction from the middle of the body, X,Y,Z")
    ->check(any("three numbers are needed, e.g. 0,0,1"))
    ->delimiter(',');
  app.add_option("--slide-to", slideTo, "end of the slide: a direction, as in --site")
    ->check(any("three numbers are needed, e.g. 0,0,1"))
    ->delimiter(',');
  app.add_option("--rate", options.rate, "ticks per second")
    ->check(within(NumberRange::between(1.0, 1e5, "ticks per second, e.g. 1000"), "1 TO 1E5"))
    ->capture_default_str();
  addContactOptions(app, options.contact);
  app.add_option("--output", options.output, "folder for pictures and trajectory")
    ->capture_default_str();
  app.add_option("--save", options.save, "also write the body with its responses, a .vtp");
  app.add_option("--export", options.exportTo,
    "also write the body with the first tool's responses for loops without VTK, a .palpate");
  app
    .add_flag("--auto,!--no-auto", options.automatic,
      "choose the form of the responses from regime, validity and spread (a point force, one law, "
      "a few laws, or a response per vertex; default; --no-auto: per vertex as computed, as always "
      "in "
      "--trial)")
    ->disable_flag_override(); // CLI11 does not report a number that is too large as a ParseError
  app
    .add_flag("--verbose", options.verbose,
      "also print the form of the responses, with its reason (--auto)")
    ->disable_flag_override();
  app
    .add_option("--tolerance", options.tolerance,
      "largest relative change of a force by the chosen form (see vtkResponseChoice)")
    ->check(positive("a relative error, e.g. 0.01"))
    ->capture_default_str();
  app
    .add_flag("--pictures,!--no-pictures", options.pictures,
      "draw pictures (default; --no-pictures: only trajectory and summary, without a display)")
    ->disable_flag_override();
  app.add_flag("--window", options.window,
    "open a window in which the mouse moves the tool, instead of writing pictures");
  app.add_option("--screenshot", options.screenshot,
    "with --window: write the last picture of the window, a .png");

  addDeviceOptions(app, options);
  addTrialOptions(app, options, alternatives);
  addViewOptions(app, options);
  addTissueOptions(app, options);

  try
  {
    app.parse(argc, argv);
    options.fixedGiven = app.count("--fixed") > 0;
    checkTissues(app, options);
    if (options.fixedGiven && options.voxel == 0.0 && !options.solid && options.tissues.empty() &&
      (options.body.empty() || !options.wholeBody))
    {
      throw CLI::RequiresError("--fixed", "--voxel or --solid, or BODY without --no-whole-body");
    }
    if (!alternatives.empty())
    {
      readTrialChoices(alternatives, options.contact, options.trial);
      takeTrialTools(options);
    }
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error);
  }
  if (app.count("--site") > 0)
  {
    options.site = site;
  }
  options.strainGiven = app.count("--strain") > 0;
  if (app.count("--layer") > 0)
  {
    options.layer.emplace();
    readLayer(layer, *options.layer);
  }
  if (app.count("--layers") > 0)
  {
    options.layer.emplace();
    readLayers(layers, *options.layer);
  }
  if (app.count("--slide-to") > 0)
  {
    options.slideTo = slideTo;
  }
  return std::nullopt;
}
} // namespace palpate
