// SPDX-License-Identifier: BSD-3-Clause
#include "pqTouchHandle.h"

#include "pqApplicationCore.h"
#include "pqProxy.h"
#include "pqServerManagerModel.h"

#include "vtkSMProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxy.h"
#include "vtkSMTrace.h"
#include "vtkSMUncheckedPropertyHelper.h"
#include "vtkSMVectorProperty.h"
#include "vtkSmartPointer.h"
#include "vtkVariant.h"

#include <QTimer>

pqTouchHandle::pqTouchHandle(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
  : Superclass(proxy, group, parent)
{
  // The panel also receives the change. follow() must run after the panel; otherwise the filter
  // would remain marked as changed. One call of follow() handles all changes that have arrived
  // before it runs.
  const auto come = [this]()
  {
    if (!this->IsPending)
    {
      this->IsPending = true;
      QTimer::singleShot(0, this, &pqTouchHandle::follow);
    }
  };
  this->connect(this, &pqPropertyWidget::changeAvailable, come);
  this->connect(this, &pqPropertyWidget::changeFinished, come);
  this->connect(
    this, &pqInteractivePropertyWidgetAbstract::endInteraction, this, &pqTouchHandle::traceEnd);
  // The panel numbers handles in its own order. Therefore each handle is named after the property
  // that it moves.
  const char* property = proxy->GetPropertyName(group->GetProperty("WorldPosition"));
  const QString position = property ? property : "";
  this->connect(this, &QObject::objectNameChanged, this,
    [this, position](const QString& name)
    {
      if (name != position)
      {
        this->setObjectName(position);
      }
    });
}

pqTouchHandle::~pqTouchHandle() = default;

bool pqTouchHandle::hasOtherChanges() const
{
  auto properties =
    vtkSmartPointer<vtkSMPropertyIterator>::Take(this->proxy()->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    vtkSMProperty* property = properties->GetProperty();
    if (!vtkSMVectorProperty::SafeDownCast(property) || property->GetInformationOnly())
    {
      continue;
    }
    const vtkSMPropertyHelper set(property);
    const vtkSMUncheckedPropertyHelper wanted(property);
    bool differs = set.GetNumberOfElements() != wanted.GetNumberOfElements();
    for (unsigned int i = 0; !differs && i < set.GetNumberOfElements(); ++i)
    {
      differs = set.GetAsVariant(i) != wanted.GetAsVariant(i);
    }
    if (differs)
    {
      return true;
    }
  }
  return false;
}

void pqTouchHandle::follow()
{
  this->IsPending = false;
  auto* filter =
    pqApplicationCore::instance()->getServerManagerModel()->findItem<pqProxy*>(this->proxy());
  if (!filter || filter->modifiedState() == pqProxy::UNINITIALIZED)
  {
    return;
  }
  this->links().accept();
  this->proxy()->UpdateVTKObjects();
  if (!this->hasOtherChanges())
  {
    filter->setModifiedState(pqProxy::UNMODIFIED);
  }
  this->render();
}

void pqTouchHandle::traceEnd()
{
  this->follow();
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", this->proxy());
  if (vtkSMProperty* position = this->propertyGroup()->GetProperty("WorldPosition"))
  {
    position->Modified();
  }
}
