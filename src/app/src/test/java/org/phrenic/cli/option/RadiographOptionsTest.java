package org.phrenic.cli.option;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.phrenic.file.BadInputException;
import org.phrenic.scene.RadiographRenderer.View;
import picocli.CommandLine;

class RadiographOptionsTest {
    private static RadiographOptions of(String... arguments) {
        RadiographOptions options = new RadiographOptions();
        new CommandLine(options).parseArgs(arguments);
        return options;
    }

    @Test
    void anglesAreLeftObliqueAndCranial() {
        RadiographOptions options = of("--xray", "0/0,-30/12.5", "--detector", "400", "--photon-energy", "70");
        options.validate();
        assertThat(options.views(64, 48))
                .containsExactly(new View(0, 0, 400, 64, 48), new View(-30, 12.5, 400, 64, 48));
        assertThat(options.energyKev()).isEqualTo(70);
        assertThat(options.views(64, 48).get(1).label()).isEqualTo("RAO 30, cranial 12.5");
        assertThat(of().given()).isFalse();
        assertThat(of().views(1, 1)).isEmpty();
    }

    @Test
    void eachViewHasAFileOfItsOwn() {
        RadiographOptions options = of("--xray", "0/0,0.4/0,30/0,30/0,-0.25/12.5");
        options.validate();
        assertThat(options.views(1, 1).stream().map(RadiographOptions::fileName))
                .containsExactly("xray_0_0", "xray_0.4_0", "xray_30_0", "xray_-0.25_12.5");
        assertThatThrownBy(() -> of("--xray", "0/0,0.0001/0").validate())
                .hasMessageContaining("--xray: found 0.0/0.0 and 1.0E-4/0.0, which give one file xray_0_0");
    }

    /** A title states the angles of its picture, so that pictures beside each other can be told apart. */
    @Test
    void aTitleStatesTheAnglesAsTheyWereGiven() {
        assertThat(of("--xray", "30/0,30.4/0,-0.4/-12.125,-0.0004/0").views(1, 1).stream()
                        .map(View::label))
                .containsExactly(
                        "LAO 30, cranial 0", "LAO 30.4, cranial 0", "RAO 0.4, caudal 12.125", "LAO 0, cranial 0");
    }

    @Test
    void whatACArmCannotDoIsRefused() {
        assertThatThrownBy(() -> of("--xray", "30").validate())
                .isInstanceOf(BadInputException.class)
                .hasMessage("--xray: found '30', expected LAO/CRAN such as 30/0");
        assertThatThrownBy(() -> of("--xray", "0/91").validate()).hasMessageContaining("-90 to 90");
        assertThatThrownBy(() -> of("--xray", "0/0", "--photon-energy", "100").validate())
                .hasMessageContaining("40 to 80");
        assertThatThrownBy(() -> of("--detector", "300").validate()).hasMessageContaining("without --xray");
    }
}
