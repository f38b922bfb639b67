// SPDX-License-Identifier: BSD-3-Clause
// palpateAccuracySpeed prints the rows of the study of accuracy against speed as CSV. Columns in
// README.md.
#include "ColdRead.h"
#include "MethodErrors.h"
#include "MethodTimer.h"
#include "RelaxationTruth.h"
#include "StrainTruth.h"
#include "StudyConvergence.h"
#include "StudyScene.h"
#include "TiltTruth.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>

#include <cstdio>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace
{
using namespace palpate::testing;

struct Options
{
  std::string output;
  std::string curves;
  std::vector<std::string> head;
  std::vector<std::string> scenes{ "block", "layer", "plate", "head" };
  bool isQuick = false;
  bool isTimed = true;
  bool withFinite = true;
  std::string strain;
  std::string relaxation;
  std::string tilt;
  bool isDeep = false;
};

/// A number of a CSV row; unknown values (not finite) give an empty field.
struct Field
{
  double value;
  int digits; ///< significant ones
};
std::ostream& operator<<(std::ostream& stream, const Field& field)
{
  if (std::isfinite(field.value))
  {
    stream << std::setprecision(field.digits) << field.value;
  }
  return stream;
}

class Report
{
public:
  explicit Report(std::ostream& stream)
    : Stream(stream)
  {
    this->Stream << "part,scene,tool,method,vertices,edge_mm,bytes_per_vertex,"
                    "model_bytes_per_vertex,tips,unanswered,error,error_sites,error_path,noticed,"
                    "error_calculix,hot_ns,onset_ns,cold_ns,size\n";
  }

  void method(const StudyScene& scene, const StudyTool& tool, const std::string& name,
    const StudyMethod& method, const MethodErrors& errors, double againstCurve,
    const MethodTimes& times)
  {
    const StudyBody& body = *scene.bodies.front();
    const auto vertices = static_cast<double>(method.vertices);
    const std::size_t bytes = method.method->bytes();
    const std::size_t beside = bytes - std::min(bytes, method.meshBytes);
    this->Stream << "methods," << scene.name << ',' << tool.name << ',' << quoted(name) << ','
                 << method.vertices << ',';
    this->Stream << Field{ body.meanEdge(), 4 } << ','
                 << Field{ static_cast<double>(bytes) / vertices, 6 } << ','
                 << Field{ static_cast<double>(beside) / vertices, 6 } << ',';
    this->Stream << errors.tips << ',' << errors.unanswered << ',';
    for (const double error :
      { errors.all, errors.sites, errors.path, errors.noticed, againstCurve })
    {
      this->Stream << Field{ error, 5 } << ',';
    }
    for (const double time : { times.hot, times.onset, times.cold })
    {
      this->Stream << Field{ time > 0.0 ? time : std::nan(""), 4 } << ',';
    }
    this->Stream << std::endl;
  }

  void convergence(const std::string& part, const std::vector<ConvergencePoint>& points)
  {
    for (const ConvergencePoint& point : points)
    {
      this->Stream << part << ',' << quoted(point.body) << ",," << quoted(point.method) << ",,,,,,,"
                   << Field{ point.error, 5 } << ",,,,,,,," << Field{ point.size, 4 } << std::endl;
    }
  }

private:
  static std::string quoted(const std::string& text)
  {
    return text.find(',') == std::string::npos ? text : '"' + text + '"';
  }
  std::ostream& Stream;
};

void studyTools(const StudyScene& scene, const Options& options, MethodTimer* timer, Report& report)
{
  for (const StudyTool& tool : scene.tools)
  {
    const StudyLaw law(tool, scene.material);
    const StudyTips tips = scene.tips(tool);
    MethodList methods = studyMethods(scene, tool);
    const StudyBody& body = *scene.bodies.front();
    methods.push_back(
      { scene.reference(law), body.pointCount(), body.meshBytes() }); // the reference comes last
    const ErrorJudge judge(tips, *methods.back().method, scene.stride);
    std::vector<MethodTimes> times(methods.size());
    if (timer != nullptr)
    {
      times = timer->run(methods, tips);
    }
    for (std::size_t i = 0; i < methods.size(); ++i)
    {
      ContactMethod& method = *methods[i].method;
      const bool isReference = i + 1 == methods.size();
      const MethodErrors errors = isReference ? MethodErrors{} : judge.judge(method);
      const std::string name = isReference ? "reference" : method.name();
      report.method(scene, tool, name, methods[i], errors,
        errorAgainstCurve(options.curves, scene, tool, method), times[i]);
    }
  }
}

std::vector<StudyScene> makeScenes(const Options& options, const StudyEffort& effort)
{
  std::vector<StudyScene> scenes;
  for (const std::string& name : options.scenes)
  {
    if (name == "block")
    {
      scenes.push_back(blockScene(effort));
    }
    else if (name == "layer")
    {
      scenes.push_back(layerScene(effort));
    }
    else if (name == "plate")
    {
      scenes.push_back(plateScene(effort));
    }
    else if (!options.head.empty())
    {
      scenes.push_back(headScene(effort, options.head));
    }
  }
  return scenes;
}

void study(const Options& options, std::ostream& stream)
{
  StudyEffort effort = options.isQuick ? StudyEffort::quick() : StudyEffort();
  effort.withFinite = options.withFinite;
  std::unique_ptr<MethodTimer> timer;
  if (options.isTimed)
  {
    timer = std::make_unique<MethodTimer>();
    if (options.isQuick)
    {
      timer->calls = 100;
      timer->passes = 2;
      timer->coldCalls = 2;
    }
    const auto read = palpate::benchmarks::measureColdRead(timer->clock(), timer->flush());
    std::cerr << "a cold read takes " << read.largePages << " ns in large pages, "
              << read.smallPages << " ns in small ones\n";
  }
  if (!options.strain.empty())
  {
    studyStrain(stream, options.strain, options.isDeep, timer.get());
    return;
  }
  if (!options.relaxation.empty())
  {
    studyRelaxation(stream, options.relaxation, timer.get());
    return;
  }
  if (!options.tilt.empty())
  {
    studyTilt(stream, options.tilt, options.isQuick, timer.get());
    return;
  }
  Report report(stream);
  const std::vector<StudyScene> scenes = makeScenes(options, effort);
  for (const StudyScene& scene : scenes)
  {
    studyTools(scene, options, timer.get(), report);
  }
  const StudyScene* const head =
    !scenes.empty() && scenes.back().name == "head" ? &scenes.back() : nullptr;
  report.convergence("mesh", meshConvergence(effort, head, options.isQuick));
  report.convergence("samples", sampleConvergence(layerScene(effort)));
}
} // namespace

int main(int argc, char* argv[])
{
  CLI::App app{ "Methods of rendering contact: error and time, as CSV." };
  Options options;
  app.add_option("--output", options.output, "file; the standard output without it");
  app.add_option("--curves", options.curves, "folder of finite-element curves to compare with");
  app.add_option("--head", options.head, "bodies prepared by run.py, fine to coarse");
  app.add_option("--scene", options.scenes, "block, layer, plate, head; all without it")
    ->check(CLI::IsMember({ "block", "layer", "plate", "head" }));
  app.add_flag("--quick", options.isQuick, "few tips");
  app.add_flag("!--no-times", options.isTimed, "errors only");
  app.add_flag("!--no-finite", options.withFinite, "without finite elements beside the tick");
  app.add_option("--strain", options.strain, "folder Data: instead, against finite strain");
  app.add_option(
    "--relaxation", options.relaxation, "folder Data: instead, bodies that relax in time");
  app.add_option("--tilt", options.tilt, "folder Data: instead, tools that lean");
  app.add_flag("--deep", options.isDeep, "--strain also where the solver is asked");
  CLI11_PARSE(app, argc, argv);
  try
  {
    std::ofstream file;
    if (!options.output.empty())
    {
      file.open(options.output);
      if (!file)
      {
        throw std::runtime_error("cannot write " + options.output);
      }
    }
    study(options, options.output.empty() ? std::cout : file);
  }
  catch (const std::exception& error)
  {
    std::cerr << "palpateAccuracySpeed: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
