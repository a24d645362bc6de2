/**
 * A scene and what it is put together from: nodes, springs, breathing, and what can be changed while it runs. Knows no
 * material and no scenario.
 */
package org.phrenic.model.assembly;
