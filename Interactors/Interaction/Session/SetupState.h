// SPDX-License-Identifier: BSD-3-Clause
// Private state of a vtkContactSetup, shared by its source files.
#ifndef SetupState_h
#define SetupState_h

#include "Interaction/Session/NewestRequest.h"
#include "Interaction/Session/ResponseMaker.h"
#include "vtkContactSetup.h"
#include "vtkContactTool.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <vector>

namespace palpate::SetupArrays
{
constexpr const char* Thickness = "LayerThickness";
// Name of the array with the thickness of the first layer of a stack.
constexpr const char* First = "LayerThickness0";
constexpr const char* Second = "LayerThickness1";
constexpr const char* Compliance = "GlobalCompliance";
} // namespace palpate::SetupArrays

struct vtkContactSetup::State
{
  vtkSmartPointer<vtkPolyData> body;
  vtkSmartPointer<vtkPolyData> copy; ///< copy of the body for use by the other thread
  std::vector<vtkSmartPointer<vtkContactTool>> tools;
  std::vector<palpate::StackLayer> added; ///< layers below the first layer

  vtkSmartPointer<vtkPolyData> output;
  palpate::MadeResponses made; ///< the responses from which the output was assembled
  /// Responses that were computed, not scaled, and the body with these responses.
  std::shared_ptr<const palpate::MadeResponses> computed;
  /// The settings that the panel changes.
  struct Settings
  {
    double youngsModulus = 0.0;
    double poissonRatio = 0.0;
    int model = 0;
    palpate::RelaxationList relaxations;
    std::vector<double> sizes; ///< sizes of the tools, mm or degrees
  };
  Settings asked;             ///< settings of the last request
  Settings shown;             ///< settings of the output
  vtkMTimeType requested = 0; ///< modification time of the last request for responses

  /// Must be the last member, so that the thread ends before the other members are destroyed.
  palpate::NewestRequest<palpate::ResponseRequest, palpate::MadeResponses> background{
    palpate::makeResponses
  };
};

#endif
