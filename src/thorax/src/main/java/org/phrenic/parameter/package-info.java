/**
 * Declarations of what a scenario can state: key, name, unit, range, default and effect of each setting. The parts of a
 * simulation declare the settings that they use; scenario files, {@code --set}, sliders, searches and
 * {@code docs/parameters.md} are made from the declarations. May use: breathing's ramp, YAML. Knows no scene.
 */
package org.phrenic.parameter;
