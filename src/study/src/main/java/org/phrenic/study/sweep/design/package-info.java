/**
 * Designs of experiments: points of the unit cube at which a model is evaluated. Independent of what the coordinates
 * stand for.
 */
package org.phrenic.study.sweep.design;
