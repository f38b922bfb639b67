// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqTouchHandle_h
#define pqTouchHandle_h

#include "pqHandlePropertyWidget.h"

/**
 * A point handle of ParaView whose filter follows the handle immediately. It is the panel widget
 * "touch_handle" of a property group. A new position (dragged, picked or typed) is passed to the
 * filter without Apply, and the view is rendered. Before the first Apply, or if other properties
 * have also changed, the position is passed at the next Apply.
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
  /// Records the position in the trace at the end of a drag, so that only the last position of the
  /// drag is traced.
  void traceEnd();

private:
  Q_DISABLE_COPY(pqTouchHandle);
  /// Whether another property of the filter waits for Apply.
  bool hasOtherChanges() const;

  bool IsPending = false; ///< whether follow() must still process a position
};

#endif
