package org.phrenic.simulation.live;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;

class RequestedSettingsTest {
    /** As of a rehearsal, which holds the breath on the thread of the simulation. */
    @Test
    void whatIsRequestedBeforeALoadBeginsIsLoaded() {
        RequestedSettings settings = new RequestedSettings(Scenario.defaults());
        assertThat(settings.request(List.of(Assignment.parse("resolution=low"))))
                .isTrue();
        assertThat(settings.request(List.of(Assignment.parse("hold=true")))).isFalse();
        Scenario loaded = settings.beginLoading();
        assertThat(loaded).isEqualTo(Scenario.defaults().with("resolution=low", "hold=true"));
        assertThat(settings.current()).isEqualTo(loaded);
    }
}
