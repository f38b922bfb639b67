// SPDX-License-Identifier: BSD-3-Clause
#include "LiveTouchSource.h"

#include "pqOutputPort.h"
#include "pqPipelineFilter.h"
#include "pqPipelineSource.h"
#include "vtkAlgorithm.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkAppendPolyData.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPolyData.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"

#include <algorithm>

namespace palpate
{
namespace
{
std::vector<StoredResponse> listResponses(vtkPVDataInformation* data)
{
  const std::string ending = "Range";
  vtkPVDataSetAttributesInformation* points = data->GetPointDataInformation();
  vtkPVDataSetAttributesInformation* fields = data->GetFieldDataInformation();
  std::vector<StoredResponse> responses;
  for (int i = 0; i < points->GetNumberOfArrays(); ++i)
  {
    const char* found = points->GetArrayInformation(i)->GetName();
    const std::string array = found ? found : "";
    const bool isRange = array.size() > ending.size() &&
      array.compare(array.size() - ending.size(), ending.size(), ending) == 0;
    StoredResponse response;
    response.name = array.substr(0, isRange ? array.size() - ending.size() : 0);
    if (isRange &&
      (points->GetArrayInformation((response.name + "Force").c_str()) ||
        points->GetArrayInformation((response.name + "Coefficient").c_str())))
    {
      vtkPVArrayInformation* tool = fields->GetArrayInformation((response.name + "Tool").c_str());
      response.tool = tool && tool->GetNumberOfStringValues() > 0 ? tool->GetStringValue(0) : "";
      responses.push_back(response);
    }
  }
  return responses;
}

/// Moves the response that the source *Touch* shows to the front of the list. Without a source
/// *Touch*, the response with the filters' default name is moved.
void putShownFirst(std::vector<StoredResponse>& responses, pqPipelineSource* touch)
{
  const char* name =
    touch ? vtkSMPropertyHelper(touch->getProxy(), "ResponseName", true).GetAsString() : nullptr;
  const std::string shown = name ? name : "Response";
  std::stable_partition(responses.begin(), responses.end(),
    [&shown](const StoredResponse& response) { return response.name == shown; });
}

using Proxy = vtkSmartPointer<vtkSMSourceProxy>;

Proxy newFilter(vtkSMSourceProxy* beside, const char* name)
{
  return Proxy::Take(
    vtkSMSourceProxy::SafeDownCast(beside->GetSessionProxyManager()->NewProxy("filters", name)));
}

/// Joins the parts of a body from several ranks. The field arrays are those of the first part that
/// has any.
vtkSmartPointer<vtkPolyData> joinParts(vtkCompositeDataSet* parts)
{
  vtkNew<vtkAppendPolyData> append;
  auto joined = vtkSmartPointer<vtkPolyData>::New();
  vtkFieldData* fields = nullptr;
  const auto each = vtkSmartPointer<vtkCompositeDataIterator>::Take(parts->NewIterator());
  for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
  {
    auto* part = vtkPolyData::SafeDownCast(each->GetCurrentDataObject());
    if (part && part->GetNumberOfPoints() > 0)
    {
      append->AddInputData(part);
      fields = fields ? fields : part->GetFieldData();
    }
  }
  if (fields)
  {
    append->Update();
    joined->ShallowCopy(append->GetOutput());
    joined->GetFieldData()->ShallowCopy(fields);
  }
  return joined;
}
} // namespace

LiveTouchSource findLiveTouchSource(pqOutputPort* active)
{
  LiveTouchSource found;
  if (!active)
  {
    found.obstacle = "Choose a body in the pipeline browser.";
    return found;
  }
  pqOutputPort* body = active;
  auto* filter = qobject_cast<pqPipelineFilter*>(active->getSource());
  if (filter && QString(filter->getProxy()->GetXMLName()) == "ToolTouch")
  {
    body = filter->getAnyInput();
    found.touch = filter;
  }
  const QString name = body ? body->getSource()->getSMName() : QString();
  if (!body || body->getSource()->modifiedState() == pqProxy::UNINITIALIZED)
  {
    found.obstacle = QString("Apply %1 first.").arg(active->getSource()->getSMName());
    return found;
  }
  vtkPVDataInformation* data = body->getDataInformation();
  found.responses = listResponses(data);
  putShownFirst(found.responses, found.touch);
  if (found.responses.empty())
  {
    found.obstacle = QString(
      "%1 has no response to a tool: apply Filters > Palpate > Tool Contact Response to it.")
                       .arg(name);
  }
  else if (data->GetDataSetType() != VTK_POLY_DATA || data->IsCompositeDataSet())
  {
    found.obstacle =
      QString("%1 is not one surface: apply Tool Contact Response after Merge Blocks.").arg(name);
  }
  else
  {
    found.body = body;
  }
  return found;
}

vtkSmartPointer<vtkPolyData> fetchBody(pqOutputPort* body, QString& error)
{
  vtkSMSourceProxy* source = body->getSourceProxy();
  const auto gather = newFilter(source, "ReductionFilter");
  const auto fetch = newFilter(source, "ClientServerMoveData");
  if (!gather || !fetch)
  {
    error = "ParaView's filters that fetch data are missing.";
    return nullptr;
  }
  vtkSMPropertyHelper(gather, "Input").Set(source, static_cast<unsigned>(body->getPortNumber()));
  vtkSMPropertyHelper(gather, "PostGatherHelperName").Set("vtkMultiBlockDataGroupFilter");
  gather->UpdateVTKObjects();
  gather->UpdatePipeline();
  vtkPVDataInformation* data = gather->GetDataInformation();
  vtkSMPropertyHelper(fetch, "Input").Set(gather);
  vtkSMPropertyHelper(fetch, "OutputDataType")
    .Set(data->IsCompositeDataSet() ? data->GetCompositeDataSetType() : data->GetDataSetType());
  fetch->UpdateVTKObjects();
  fetch->UpdatePipeline();
  auto* here = vtkAlgorithm::SafeDownCast(fetch->GetClientSideObject());
  vtkDataObject* got = here ? here->GetOutputDataObject(0) : nullptr;
  vtkSmartPointer<vtkPolyData> fetched;
  if (auto* parts = vtkCompositeDataSet::SafeDownCast(got))
  {
    fetched = joinParts(parts);
  }
  else if (auto* whole = vtkPolyData::SafeDownCast(got))
  {
    fetched = vtkSmartPointer<vtkPolyData>::New();
    fetched->ShallowCopy(whole);
  }
  if (!fetched || fetched->GetNumberOfPolys() == 0)
  {
    error = QString("%1 has no triangles.").arg(body->getSource()->getSMName());
    return nullptr;
  }
  return fetched;
}

TouchHandle readTouchHandle(pqPipelineSource* touch)
{
  vtkSMProxy* proxy = touch->getProxy();
  const auto read = [proxy](const char* name, unsigned i, double missing)
  {
    vtkSMUncheckedPropertyHelper property(proxy, name, true);
    return property.GetNumberOfElements() > i ? property.GetAsDouble(i) : missing;
  };
  TouchHandle handle;
  for (unsigned i = 0; i < 3; ++i)
  {
    handle.position[i] = read("TipPosition", i, 0.0);
  }
  handle.snaps = read("Snap", 0, 1.0) != 0.0;
  handle.depth = read("Indentation", 0, 0.0);
  return handle;
}
} // namespace palpate
