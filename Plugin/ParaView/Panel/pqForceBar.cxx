// SPDX-License-Identifier: BSD-3-Clause
#include "pqForceBar.h"

#include <QPainter>

#include <algorithm>

pqForceBar::pqForceBar(QWidget* parent)
  : QWidget(parent)
{
}

void pqForceBar::setScale(double fullScale, double limit)
{
  this->FullScale = fullScale > 0.0 ? fullScale : 1.0;
  this->Limit = limit;
  this->update();
}

void pqForceBar::setForce(double applied, double ideal)
{
  this->Applied = applied;
  this->Ideal = ideal;
  this->update();
}

void pqForceBar::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  const QRect frame = this->rect().adjusted(0, 0, -1, -1);
  const auto along = [this, &frame](double force)
  {
    const double share = std::clamp(force / this->FullScale, 0.0, 1.0);
    return static_cast<int>(share * (frame.width() - 2));
  };
  painter.fillRect(frame, this->palette().base());
  painter.fillRect(1, 2, along(this->Applied), frame.height() - 3, this->palette().highlight());
  painter.setPen(this->palette().color(QPalette::Text));
  painter.drawRect(1, 2, along(this->Ideal), frame.height() - 4);
  painter.setPen(this->palette().color(QPalette::Mid));
  painter.drawRect(frame);
  if (this->Limit > 0.0 && this->Limit <= this->FullScale)
  {
    painter.setPen(QPen(QColor(200, 30, 30), 2));
    const int mark = 1 + along(this->Limit);
    painter.drawLine(mark, 0, mark, frame.height());
  }
}
