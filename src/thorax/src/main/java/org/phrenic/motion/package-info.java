/**
 * Where every point of a body goes as it breathes: displacement fields that are rigid in bones, follow the surfaces of
 * organs inside them and slide at the pleura; their inverses, and images carried by them.
 */
package org.phrenic.motion;
