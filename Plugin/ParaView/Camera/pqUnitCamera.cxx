// SPDX-License-Identifier: BSD-3-Clause
#include "pqUnitCamera.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "pqServerManagerModel.h"

#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMViewProxy.h"

#include <QTimer>

namespace
{
const char* const Unit = "LengthUnit";

int unitOf(pqPipelineSource* source)
{
  return vtkSMPropertyHelper(source->getProxy(), Unit).GetAsInt();
}

/// Returns the render views in which an output of these sources is visible.
QSet<pqRenderView*> viewsOf(const QList<pqPipelineSource*>& sources)
{
  QSet<pqRenderView*> views;
  for (pqPipelineSource* source : sources)
  {
    for (pqView* view : source->getViews())
    {
      auto* render = qobject_cast<pqRenderView*>(view);
      for (int port = 0; render && port < source->getNumberOfOutputPorts(); ++port)
      {
        pqDataRepresentation* shown = source->getOutputPort(port)->getRepresentation(render);
        if (shown && shown->isVisible())
        {
          views.insert(render);
        }
      }
    }
  }
  return views;
}
} // namespace

pqUnitCamera::pqUnitCamera(QObject* parent)
  : QObject(parent)
{
}

pqUnitCamera::~pqUnitCamera() = default;

void pqUnitCamera::startup()
{
  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::connect(model, &pqServerManagerModel::sourceAdded, this, &pqUnitCamera::watch);
  QObject::connect(model, &pqServerManagerModel::preSourceRemoved, this, &pqUnitCamera::forget);
  QObject::connect(model, &pqServerManagerModel::dataUpdated, this, &pqUnitCamera::onDataUpdated);
  for (pqPipelineSource* source : model->findItems<pqPipelineSource*>())
  {
    this->watch(source);
  }
}

void pqUnitCamera::watch(pqPipelineSource* source)
{
  // A state file sets properties before ParaView announces the source.
  const QString group = source->getProxy()->GetXMLGroup();
  if (group == "filters" && source->getProxy()->GetProperty(Unit))
  {
    this->Units[source] = unitOf(source);
    QObject::connect(
      source, &pqPipelineSource::visibilityChanged, this, &pqUnitCamera::resetViewsSoon);
  }
}

void pqUnitCamera::forget(pqPipelineSource* source)
{
  this->Units.remove(source);
  this->Waiting.remove(source);
}

void pqUnitCamera::onDataUpdated(pqPipelineSource* source)
{
  const auto seen = this->Units.find(source);
  if (seen == this->Units.end() || seen.value() == unitOf(source))
  {
    return;
  }
  seen.value() = unitOf(source);
  this->Waiting.insert(source);
  this->resetViewsSoon();
}

/// Resets the views after the pipeline has finished, and after the classes that make the sources
/// visible have finished.
void pqUnitCamera::resetViewsSoon()
{
  if (!this->Waiting.isEmpty())
  {
    QTimer::singleShot(0, this, &pqUnitCamera::resetViews);
  }
}

void pqUnitCamera::resetViews()
{
  const QSet<pqPipelineSource*> waiting = this->Waiting;
  for (pqPipelineSource* source : waiting)
  {
    const QSet<pqRenderView*> views = viewsOf(source->getAllConsumers() << source);
    for (pqRenderView* view : views)
    {
      this->Waiting.remove(source);
      view->getViewProxy()->Update(); // updates the bounds that the camera is reset to
      view->resetCamera();
      view->render();
    }
  }
}
