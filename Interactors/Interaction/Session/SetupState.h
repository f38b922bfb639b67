// SPDX-License-Identifier: BSD-3-Clause
// What a vtkContactSetup keeps, for the files that it is made of.
#ifndef SetupState_h
#define SetupState_h

#include "Interaction/Session/NewestRequest.h"
#include "Interaction/Session/ResponseMaker.h"
#include "vtkContactSetup.h"
#include "vtkContactTool.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace palpate::SetupArrays
{
constexpr const char* Thickness = "LayerThickness";
constexpr const char* First = "LayerThickness0"; // of a stack
constexpr const char* Second = "LayerThickness1";
constexpr const char* Compliance = "GlobalCompliance";
} // namespace palpate::SetupArrays

struct vtkContactSetup::State
{
  vtkSmartPointer<vtkPolyData> body;
  vtkSmartPointer<vtkPolyData> copy; ///< a copy of the body for the other thread
  std::vector<vtkSmartPointer<vtkContactTool>> tools;
  std::vector<palpate::StackLayer> added; ///< layers below the first

  vtkSmartPointer<vtkPolyData> output;
  palpate::MadeResponses made; ///< what the output was assembled from
  vtkMTimeType requested = 0;  ///< modification time of the last request for responses

  /// Last, so that it is destroyed first.
  palpate::NewestRequest<palpate::ResponseRequest, palpate::MadeResponses> background{
    palpate::makeResponses
  };
};

#endif
