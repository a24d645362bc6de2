/** Breathing presets held against a table of physiology. */
package org.phrenic.study.validation;
