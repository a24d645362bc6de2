package org.phrenic.motion;

/** What moves the inside of a lung. */
public enum LungInside {
    /** The vertices of its surface ({@link HarmonicExtension}): exact on the surface of the simulation. */
    VERTICES,
    /**
     * The shape of its surface alone ({@link SlidingElasticSolid}): the tissue slides in the pleura, otherwise than the
     * vertices do.
     */
    ELASTIC
}
