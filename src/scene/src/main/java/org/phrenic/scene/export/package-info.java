/** Picture and movie files. */
package org.phrenic.scene.export;
