/** Pictures and movies as files. Knows nothing of scenes. */
package org.phrenic.scene.export;
