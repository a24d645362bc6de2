/**
 * Docks and panels of the rehearsal of liver access. They show its state and pass commands to it; they decide nothing.
 */
package org.phrenic.ui.access.panel;
