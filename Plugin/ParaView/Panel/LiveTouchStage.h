// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_LiveTouchStage_h
#define palpate_LiveTouchStage_h

#include "LiveTouchPlace.h"

#include "vtkHandleWidget.h"
#include "vtkHapticToolRepresentation.h"
#include "vtkNew.h"
#include "vtkPointHandleRepresentation3D.h"

class pqRenderView;
class vtkObject;

namespace palpate
{
class LiveTouchSession;

/**
 * The tool, the force arrow and, if needed, a handle in a view of ParaView. The client draws these
 * objects over the server's picture, as it draws ParaView's own widgets. They are part of neither
 * the pipeline nor a state file.
 */
class LiveTouchStage
{
public:
  LiveTouchStage();
  ~LiveTouchStage() { this->leave(); }
  LiveTouchStage(const LiveTouchStage&) = delete;
  LiveTouchStage& operator=(const LiveTouchStage&) = delete;

  /// Adds the objects to a view, and removes them from the previous one.
  void enter(pqRenderView* view);
  void leave();
  pqRenderView* view() const { return this->View; }

  /// Fits tool and arrow to the size of the body, and shows the tool above its target.
  void prepare(LiveTouchSession& touch);
  /// Moves tool and arrow to the newest tick. Returns false if the movement is not visible.
  bool show(LiveTouchSession& touch);

  ///@{
  /// The handle of this class, which the user drags. When it is released, it jumps to the surface.
  void showHandle(const Eigen::Vector3d& position);
  bool hasHandle() const;
  Eigen::Vector3d handle() const;
  void settleHandle(const LiveTouchPlace& place);
  ///@}

private:
  static void onRelease(vtkObject*, unsigned long, void* stage, void*);

  pqRenderView* View = nullptr;
  vtkNew<vtkHapticToolRepresentation> Tool;
  vtkNew<vtkHandleWidget> Widget;
  vtkNew<vtkPointHandleRepresentation3D> Cross;
  bool Released = false;
  bool ShowsNothing = true;
  Eigen::Vector3d Tip = Eigen::Vector3d::Zero(); ///< position of the tip in the present picture
  Eigen::Vector3d Force = Eigen::Vector3d::Zero();
  Eigen::Vector3d Applied = Eigen::Vector3d::Zero();
};
} // namespace palpate

#endif
