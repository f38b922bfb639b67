// SPDX-License-Identifier: BSD-3-Clause
#include "pqLiveTouchPanel.h"

#include "TouchSight.h"
#include "LiveTouchSource.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqRenderView.h"
#include "pqServerManagerModel.h"
#include "vtkPVXMLElement.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>

#include <algorithm>

namespace
{
constexpr int FrameTime = 16; // time between two frames, ms
// Time between two updates of the numbers, ms; numbers that change faster cannot be read.
constexpr int NumbersTime = 100;
constexpr int RateTime = 1000; // time between two measurements of the tick rate, ms
} // namespace

pqLiveTouchPanel::pqLiveTouchPanel(QWidget* parent)
  : QDockWidget("Live Touch", parent)
{
  auto* scroll = new QScrollArea(this);
  scroll->setObjectName("scroll");
  scroll->setWidgetResizable(true);
  auto* contents = new QWidget(scroll);
  contents->setObjectName("contents");
  this->Form = new palpate::LiveTouchForm(contents);
  scroll->setWidget(contents);
  this->setWidget(scroll);
  this->hide(); // hidden until the user opens the panel from the menu View

  this->Frame.setInterval(FrameTime);
  QObject::connect(&this->Frame, &QTimer::timeout, this, &pqLiveTouchPanel::frame);
  QObject::connect(this->Form->start, &QPushButton::clicked, this, &pqLiveTouchPanel::startOrStop);
  QObject::connect(
    this->Form->find, &QToolButton::clicked, this, [this]() { this->Form->listDevices(); });
  QObject::connect(this->Form->response, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
    &pqLiveTouchPanel::takeBody);

  QObject::connect(
    this->toggleViewAction(), &QAction::triggered, this, &pqLiveTouchPanel::onToggled);
  auto* active = &pqActiveObjects::instance();
  QObject::connect(active, &pqActiveObjects::portChanged, this, &pqLiveTouchPanel::showSource);
  auto* core = pqApplicationCore::instance();
  auto* model = core->getServerManagerModel();
  QObject::connect(
    model, &pqServerManagerModel::dataUpdated, this, &pqLiveTouchPanel::onDataUpdated);
  QObject::connect(model, &pqServerManagerModel::modifiedStateChanged, this,
    &pqLiveTouchPanel::showSource); // this is called on the first Apply of a source
  QObject::connect(
    model, &pqServerManagerModel::preSourceRemoved, this, &pqLiveTouchPanel::onSourceGoes);
  QObject::connect(
    model, &pqServerManagerModel::preViewRemoved, this, &pqLiveTouchPanel::onViewGoes);
  QObject::connect(
    model, &pqServerManagerModel::aboutToRemoveServer, this, &pqLiveTouchPanel::stop);
  QObject::connect(model, &pqServerManagerModel::preServerRemoved, this, &pqLiveTouchPanel::stop);
  QObject::connect(core, &pqApplicationCore::aboutToLoadState, this, &pqLiveTouchPanel::stop);
  QObject::connect(
    QCoreApplication::instance(), &QCoreApplication::aboutToQuit, this, &pqLiveTouchPanel::stop);
}

pqLiveTouchPanel::~pqLiveTouchPanel()
{
  // When the program ends, source and view may no longer exist.
  this->Touch.stop();
  delete this->Form;
}

void pqLiveTouchPanel::showEvent(QShowEvent* event)
{
  this->QDockWidget::showEvent(event);
  if (this->isIdle())
  {
    this->Form->listDevices();
    this->showSource();
  }
}

void pqLiveTouchPanel::closeEvent(QCloseEvent* event)
{
  this->stop(); // without the panel the user could not end the force
  this->QDockWidget::closeEvent(event);
}

void pqLiveTouchPanel::showSource()
{
  if (!this->isIdle() || !this->isVisible())
  {
    // A running session continues with the body of its Start, and a hidden panel does not query the
    // server.
    return;
  }
  const auto source = palpate::findLiveTouchSource(pqActiveObjects::instance().activePort());
  const QString leads = source.touch ? ", led by " + source.touch->getSMName() : QString();
  this->Form->showSource(
    source, source.body ? source.body->getSource()->getSMName() + leads : QString());
  this->Form->depth->setEnabled(!source.touch);
  this->Form->snap->setEnabled(!source.touch);
  this->CanStart = source.body != nullptr;
  this->Form->showRest(this->Touch, this->CanStart, this->Fault);
}

void pqLiveTouchPanel::startOrStop()
{
  if (this->isIdle())
  {
    this->start();
  }
  else
  {
    this->stop();
  }
}

void pqLiveTouchPanel::onToggled(bool shown)
{
  if (!shown)
  {
    this->stop(); // stops as if the panel were closed
  }
}

void pqLiveTouchPanel::start()
{
  const auto source = palpate::findLiveTouchSource(pqActiveObjects::instance().activePort());
  auto* view = qobject_cast<pqRenderView*>(pqActiveObjects::instance().activeView());
  if (!source.body || !view)
  {
    this->fail(source.body ? "Click into a 3D view first." : source.obstacle);
    return;
  }
  QString error;
  this->Fetching = true;
  const auto body = palpate::fetchBody(source.body, error);
  this->Fetching = false;
  if (!body)
  {
    this->fail(error);
    return;
  }
  this->Fault.clear();
  this->Body = source.body;
  this->Leader = source.touch;
  this->Stage.enter(view);
  QObject::connect(view, &pqView::beginRender, this, &pqLiveTouchPanel::onRenderBegins);
  QObject::connect(view, &pqView::endRender, this, &pqLiveTouchPanel::onRenderEnds);

  this->Touch.start(body, this->Form->chosenResponse().toStdString(),
    this->Form->chosenDevice().toStdString(), this->readHandle(),
    palpate::sightOf(view->getProxy()));
  this->Shown.start();
  this->RenderTime = 0;
  this->Rest.start();
  this->Frame.start();
  this->Form->showRest(this->Touch, this->CanStart, this->Fault);
}

void pqLiveTouchPanel::fail(const QString& error)
{
  this->Fault = error;
  this->Form->showRest(this->Touch, this->CanStart, this->Fault);
}

void pqLiveTouchPanel::stop()
{
  this->Touch.stop(); // the force must end before the body is removed
  this->Frame.stop();
  if (!this->Body)
  {
    return;
  }
  this->Body = nullptr;
  this->Leader = nullptr;
  if (pqRenderView* view = this->Stage.view())
  {
    QObject::disconnect(view, nullptr, this, nullptr);
    this->Stage.leave();
    view->render();
  }
  this->Form->showRest(this->Touch, this->CanStart, this->Fault);
  // Runs after the removal of the source.
  QTimer::singleShot(0, this, &pqLiveTouchPanel::showSource);
}

palpate::TouchHandle pqLiveTouchPanel::readHandle() const
{
  if (this->Leader)
  {
    return palpate::readTouchHandle(this->Leader);
  }
  palpate::TouchHandle handle;
  handle.isToBeFound = !this->Stage.hasHandle();
  handle.position = handle.isToBeFound ? handle.position : this->Stage.handle();
  handle.depth = this->Form->depth->value();
  handle.snaps = this->Form->snap->isChecked();
  return handle;
}

void pqLiveTouchPanel::frame()
{
  if (this->Touch.collect())
  {
    this->onSessionChanged();
  }
  // If rendering is slow, at least half of the time remains for the user's input.
  if (this->Touch.state() != palpate::LiveTouchSession::State::Touching ||
    this->Rest.elapsed() < this->RenderTime)
  {
    return;
  }
  if (!this->Touch.steer(this->readHandle()))
  {
    this->onSessionChanged();
    return;
  }
  this->Stage.settleHandle(this->Touch.place());
  if (this->Stage.show(this->Touch))
  {
    this->Stage.view()->render();
  }
  if (this->Shown.elapsed() >= NumbersTime)
  {
    this->showNumbers();
  }
}

void pqLiveTouchPanel::showNumbers()
{
  this->Shown.start();
  if (this->Measured.elapsed() >= RateTime)
  {
    const vtkIdType ticks = this->Touch.session()->GetNumberOfTicks();
    const vtkIdType made = std::max<vtkIdType>(0, ticks - this->MeasuredTicks);
    this->Rate = 1000.0 * static_cast<double>(made) / static_cast<double>(this->Measured.elapsed());
    this->MeasuredTicks = ticks;
    this->Measured.start();
  }
  this->Form->showTouch(this->Touch, this->Rate);
}

void pqLiveTouchPanel::onSessionChanged()
{
  if (this->isIdle())
  {
    const QString error = QString::fromStdString(this->Touch.error());
    this->stop();
    this->fail(error);
    return;
  }
  this->Stage.prepare(this->Touch);
  this->Measured.start();
  this->Rate = 0.0;
  this->MeasuredTicks = this->Touch.session() ? this->Touch.session()->GetNumberOfTicks() : 0;
  const bool isSimulated =
    this->Touch.session() && this->Touch.session()->GetDevice()->IsSimulated();
  if (isSimulated && !this->Leader && !this->Stage.hasHandle())
  {
    this->Stage.showHandle(this->Touch.place().surface);
  }
}

void pqLiveTouchPanel::takeBody()
{
  if (this->isIdle() || this->Fetching)
  {
    return;
  }
  QString error;
  this->Fetching = true;
  const auto body = palpate::fetchBody(this->Body, error);
  this->Fetching = false;
  if (body)
  {
    this->Touch.replace(body, this->Form->chosenResponse().toStdString());
  }
}

void pqLiveTouchPanel::onDataUpdated(pqPipelineSource* source)
{
  if (this->isIdle())
  {
    this->showSource();
  }
  else if (!this->Fetching && source == this->Body->getSource())
  {
    // Delayed, because the pipeline is still executing.
    QTimer::singleShot(0, this, &pqLiveTouchPanel::takeBody);
  }
}

void pqLiveTouchPanel::onSourceGoes(pqPipelineSource* source)
{
  if (this->Body && (source == this->Body->getSource() || source == this->Leader))
  {
    this->stop();
  }
}

void pqLiveTouchPanel::onViewGoes(pqView* view)
{
  if (view == this->Stage.view())
  {
    this->stop();
  }
}

void pqLiveTouchPanel::onRenderBegins()
{
  this->Rendering.start();
}

void pqLiveTouchPanel::onRenderEnds()
{
  this->RenderTime = this->Rendering.isValid() ? this->Rendering.elapsed() : 0;
  this->Rest.start();
}
