package org.phrenic.patient;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class MeshingSettingsTest {
    /** Villard, Bourne and Bello 2009, section 4.1: pass band 0.2, 50 % decimation, 200 more iterations. */
    @Test
    void thePapersSettingsAreThosePublished() {
        assertThat(MeshingSettings.PAPER.passBand()).isEqualTo(0.2);
        assertThat(MeshingSettings.PAPER.keptFraction()).isEqualTo(0.5);
        assertThat(MeshingSettings.PAPER.secondIterations()).isEqualTo(200);
    }
}
