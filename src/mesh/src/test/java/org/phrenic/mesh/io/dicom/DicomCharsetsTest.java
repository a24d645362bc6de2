package org.phrenic.mesh.io.dicom;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

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

    /** "Zou", two letters and a sign of voicing, where the value names a set of two bytes too. */
    @Test
    void halfWidthKatakanaBesideKanjiAreRead() {
        byte[] zou = {(byte) 0xbf, (byte) 0xde, (byte) 0xb3};
        assertThat(DicomCharsets.text(zou, DicomCharsets.of("ISO 2022 IR 13\\ISO 2022 IR 87")))
                .isEqualTo("\uff7f\uff9e\uff73");
        byte[] both = {(byte) 0xbf, (byte) 0xde, '=', 0x1b, 0x24, 0x42, 0x3b, 0x33, 0x45, 0x44, 0x1b, 0x28, 0x4a};
        assertThat(DicomCharsets.text(both, DicomCharsets.of("ISO 2022 IR 13\\ISO 2022 IR 87")))
                .isEqualTo("\uff7f\uff9e=\u5c71\u7530");
    }

    /** Bytes of the examples of PS3.5, annexes I.2 and K.2, which a sequence of escape begins. */
    @Test
    void namesAfterAnEscapeSequenceAreReadWithoutIt() {
        byte[] hong = {0x1b, 0x24, 0x29, 0x43, (byte) 0xfb, (byte) 0xf3, ' ', 'r', 'i', 'b'};
        assertThat(DicomCharsets.text(hong, DicomCharsets.of("\\ISO 2022 IR 149")))
                .isEqualTo("洪 rib");
        byte[] zhang = {0x1b, 0x24, 0x29, 0x41, (byte) 0xd5, (byte) 0xc5};
        assertThat(DicomCharsets.text(zhang, DicomCharsets.of("\\ISO 2022 IR 58")))
                .isEqualTo("张");
        byte[] yamada = {0x1b, 0x24, 0x42, 0x3b, 0x33, 0x45, 0x44, 0x1b, 0x28, 0x42};
        assertThat(DicomCharsets.text(yamada, DicomCharsets.of("ISO 2022 IR 6\\ISO 2022 IR 87")))
                .isEqualTo("山田");
        byte[] lung = {0x1b, 0x2d, 0x4c, (byte) 0xdb, (byte) 0xd5, (byte) 0xd3, (byte) 0xda, (byte) 0xde, (byte) 0xd5};
        assertThat(DicomCharsets.text(lung, DicomCharsets.of("\\ISO 2022 IR 144")))
                .isEqualTo("легкое");
    }

    /** The same set with escape sequences and without. */
    @ParameterizedTest
    @CsvSource({
        "101, ISO-8859-2",
        "109, ISO-8859-3",
        "110, ISO-8859-4",
        "144, ISO-8859-5",
        "127, ISO-8859-6",
        "126, ISO-8859-7",
        "138, ISO-8859-8",
        "148, ISO-8859-9",
        "203, ISO-8859-15",
        "166, TIS-620"
    })
    void setsOfSingleBytesHaveTwoTerms(String set, String name) {
        Charset expected = Charset.forName(name);
        assertThat(DicomCharsets.of("ISO_IR " + set)).isEqualTo(expected);
        assertThat(DicomCharsets.of("ISO 2022 IR " + set)).isEqualTo(expected);
    }

    @Test
    void anUnknownSetIsLatin() {
        assertThat(DicomCharsets.of("ISO_IR 100")).isEqualTo(StandardCharsets.ISO_8859_1);
        assertThat(DicomCharsets.of("ISO 2022 IR 100")).isEqualTo(StandardCharsets.ISO_8859_1);
        assertThat(DicomCharsets.of("")).isEqualTo(StandardCharsets.ISO_8859_1);
    }
}
