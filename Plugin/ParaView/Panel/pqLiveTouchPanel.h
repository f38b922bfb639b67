// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqLiveTouchPanel_h
#define pqLiveTouchPanel_h

#include "LiveTouchForm.h"
#include "LiveTouchSession.h"
#include "LiveTouchStage.h"

#include <QDockWidget>
#include <QElapsedTimer>
#include <QTimer>

class pqOutputPort;
class pqPipelineSource;
class pqServer;
class pqView;

/**
 * The dock *Live Touch*: the active source's body under a haptic device, felt by a servo thread and
 * shown in the active render view.
 *
 * It connects widgets (LiveTouchForm), session (LiveTouchSession), pipeline (LiveTouchSource) and
 * view (LiveTouchStage). A timer reads the newest tick some 60 times a second while a session runs;
 * the view is rendered when the tool has moved, and half of the time is left to the user. It never
 * waits for the servo thread or a preparation, only for data of a remote server.
 *
 * The session ends, with no force on the device, when the dock is closed, before its source, view
 * or server is removed, before a state is loaded, and when ParaView quits. Body, view and handle
 * are those of the Start; new data of the body replace the old.
 */
class pqLiveTouchPanel : public QDockWidget
{
  Q_OBJECT

public:
  explicit pqLiveTouchPanel(QWidget* parent = nullptr);
  ~pqLiveTouchPanel() override;

private Q_SLOTS:
  void startOrStop();
  void stop();
  void onToggled(bool shown);
  void frame();
  void showSource();
  void takeBody();
  void onDataUpdated(pqPipelineSource* source);
  void onSourceGoes(pqPipelineSource* source);
  void onViewGoes(pqView* view);
  void onRenderBegins();
  void onRenderEnds();

protected:
  void showEvent(QShowEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

private:
  void start();
  void fail(const QString& error);
  void onSessionChanged();
  palpate::TouchHandle readHandle() const;
  void showNumbers();
  bool isIdle() const { return this->Touch.state() == palpate::LiveTouchSession::State::Idle; }

  palpate::LiveTouchForm* Form; ///< owned, like its widgets
  palpate::LiveTouchStage Stage;
  palpate::LiveTouchSession Touch;    ///< after the stage, so that it is destroyed first
  pqOutputPort* Body = nullptr;       ///< touched; null while idle
  pqPipelineSource* Leader = nullptr; ///< whose handle leads the tip, or null
  bool CanStart = false;
  QString Fault; ///< why the last start failed
  bool Fetching = false;
  QTimer Frame;
  QElapsedTimer Rendering; ///< since the last one began
  QElapsedTimer Rest;      ///< since the last one ended
  qint64 RenderTime = 0;   ///< ms, of the last one
  QElapsedTimer Shown;     ///< since numbers were shown
  QElapsedTimer Measured;  ///< since ticks were counted
  vtkIdType MeasuredTicks = 0;
  double Rate = 0.0; ///< ticks per second
};

#endif
