package org.phrenic.mesh.io.dicom;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

class DicomCharsetsTest {
    /** Bytes of the examples of PS3.5, annexes H.3 and J, and of "liver" in GB18030. */
    @Test
    void namesInEastAsianCharacterSetsAreRead() {
        byte[] yamada = {0x1b, 0x24, 0x42, 0x3b, 0x33, 0x45, 0x44, 0x1b, 0x28, 0x42};
        assertThat(new String(yamada, DicomCharsets.of("\\ISO 2022 IR 87"))).isEqualTo("山田");
        byte[] liver = {(byte) 0xb8, (byte) 0xce, (byte) 0xd4, (byte) 0xe0};
        assertThat(new String(liver, DicomCharsets.of("GB18030"))).isEqualTo("肝脏");
        assertThat(new String("肝".getBytes(StandardCharsets.UTF_8), DicomCharsets.of("ISO_IR 192")))
                .isEqualTo("肝");
    }

    @Test
    void anUnknownSetIsLatin() {
        assertThat(DicomCharsets.of("ISO_IR 100")).isEqualTo(StandardCharsets.ISO_8859_1);
        assertThat(DicomCharsets.of("")).isEqualTo(StandardCharsets.ISO_8859_1);
    }
}
