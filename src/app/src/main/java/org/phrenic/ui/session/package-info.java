/**
 * What all parts of the window share: the running simulation and its events, edits, preferences, background tasks. No
 * component, and nothing that draws.
 */
package org.phrenic.ui.session;
