package org.phrenic.model.organ;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class LungBaseMotionTest {
    private static int first(String track) {
        return LungBaseMotion.firstApposed(3, 3 + track.length(), q -> track.charAt(q - 3) == 'w') - 3;
    }

    /** Points of a track on the wall (w) and off it (.), from the vertex to the insertion. */
    @Test
    void theZoneOfAppositionIsWhereATrackStaysOnTheWall() {
        assertThat(first("....wwwww")).isEqualTo(4);
        assertThat(first("wwwww")).isZero();
        assertThat(first("..ww...www.w..")).as("dents").isEqualTo(2);
        assertThat(first("ww................www")).as("over the dome").isEqualTo(18);
        assertThat(first("....")).isEqualTo(4);
    }
}
