// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqTouchHandle_h
#define pqTouchHandle_h

#include "pqHandlePropertyWidget.h"

/**
 * ParaView's point handle, with a filter that follows it immediately: the panel widget
 * "touch_handle" of a property group. A new position (dragged, picked or typed) is passed to the
 * filter without Apply, and the view is rendered. Before the first Apply, or if other properties
 * have also changed, the position waits for Apply.
 */
class pqTouchHandle : public pqHandlePropertyWidget
{
  Q_OBJECT
  typedef pqHandlePropertyWidget Superclass;

public:
  pqTouchHandle(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent = nullptr);
  ~pqTouchHandle() override;

private Q_SLOTS:
  void follow();
  /// At the end of a drag: traces only the last position.
  void traceEnd();

private:
  Q_DISABLE_COPY(pqTouchHandle);
  /// Whether a property of the filter waits for Apply.
  bool hasOtherChanges() const;

  bool IsPending = false; ///< whether follow() must still process a position
};

#endif
