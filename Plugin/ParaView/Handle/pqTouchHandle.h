// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqTouchHandle_h
#define pqTouchHandle_h

#include "pqHandlePropertyWidget.h"

/**
 * ParaView's point handle, whose filter follows it at once: the property group's panel widget
 * "touch_handle". A new position, dragged, picked or typed, is given to the filter without Apply,
 * and the view is drawn. Before the first Apply, or with changes of other properties, it waits for
 * Apply.
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
  /// The end of a drag: traces the last position alone.
  void traceEnd();

private:
  Q_DISABLE_COPY(pqTouchHandle);
  /// Whether a property of the filter waits for Apply.
  bool hasOtherChanges() const;

  bool IsPending = false; ///< a position that follow() has not seen
};

#endif
