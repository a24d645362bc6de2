package org.phrenic.mesh.io.dicom;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Character sets by the defined terms of Specific Character Set (DICOM PS3.3, C.12.1.1.2). Of several the first known
 * one beyond Latin 1 counts: the sets with escape sequences contain ASCII.
 */
final class DicomCharsets {
    private static final Map<String, String> NAMES = new LinkedHashMap<>();

    static {
        NAMES.put("ISO_IR 192", "UTF-8");
        NAMES.put("GB18030", "GB18030");
        NAMES.put("GBK", "GB18030");
        NAMES.put("ISO 2022 IR 87", "ISO-2022-JP");
        NAMES.put("ISO 2022 IR 149", "EUC-KR");
        NAMES.put("ISO_IR 13", "JIS_X0201");
        NAMES.put("ISO_IR 101", "ISO-8859-2");
        NAMES.put("ISO_IR 144", "ISO-8859-5");
        NAMES.put("ISO_IR 126", "ISO-8859-7");
        NAMES.put("ISO_IR 148", "ISO-8859-9");
    }

    private DicomCharsets() {}

    /** The character set of a value; Latin 1 if it is unknown or this Java does not have it. */
    static Charset of(String value) {
        return NAMES.entrySet().stream()
                .filter(name -> value.contains(name.getKey()) && Charset.isSupported(name.getValue()))
                .findFirst()
                .map(name -> Charset.forName(name.getValue()))
                .orElse(StandardCharsets.ISO_8859_1);
    }
}
