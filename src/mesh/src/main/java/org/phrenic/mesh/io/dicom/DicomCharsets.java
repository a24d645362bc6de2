package org.phrenic.mesh.io.dicom;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;

/**
 * Character sets by the defined terms of Specific Character Set (DICOM PS3.3, C.12.1.1.2). Of several that one counts
 * which comes first in the table here: the sets with escape sequences contain ASCII. A set of single bytes has one term
 * without ("ISO_IR 144") and one with escape sequences ("ISO 2022 IR 144").
 */
final class DicomCharsets {
    private static final Map<String, String> NAMES = new LinkedHashMap<>();

    static {
        NAMES.put("ISO_IR 192", "UTF-8");
        NAMES.put("GB18030", "GB18030");
        NAMES.put("GBK", "GB18030");
        NAMES.put("ISO_IR 87", "ISO-2022-JP");
        NAMES.put("ISO_IR 149", "EUC-KR");
        NAMES.put("ISO_IR 58", "GB2312");
        NAMES.put("ISO_IR 13", "JIS_X0201");
        NAMES.put("ISO_IR 101", "ISO-8859-2");
        NAMES.put("ISO_IR 109", "ISO-8859-3");
        NAMES.put("ISO_IR 110", "ISO-8859-4");
        NAMES.put("ISO_IR 144", "ISO-8859-5");
        NAMES.put("ISO_IR 127", "ISO-8859-6");
        NAMES.put("ISO_IR 126", "ISO-8859-7");
        NAMES.put("ISO_IR 138", "ISO-8859-8");
        NAMES.put("ISO_IR 148", "ISO-8859-9");
        NAMES.put("ISO_IR 203", "ISO-8859-15");
        NAMES.put("ISO_IR 166", "TIS-620");
    }

    /** Escape sequences that choose a set, which other decoders than that of ISO-2022-JP leave in the text. */
    private static final Pattern ESCAPE = Pattern.compile("\u001b\\$?[()\\-.][@-~]");
    /** Half-width katakana, which stand beside the sets of two bytes in Japanese names. */
    private static final String KATAKANA = "JIS_X0201";

    private static final byte ESC = 0x1b;
    /** Bytes of half-width katakana are above it. */
    private static final int LAST_OF_ASCII = 0x7f;

    private DicomCharsets() {}

    /** The character set of a value; Latin 1 if it is unknown or this Java does not have it. */
    static Charset of(String value) {
        List<String> terms = Arrays.stream(value.split("\\\\", -1))
                .map(term -> term.strip().replaceFirst("^ISO 2022 IR ", "ISO_IR "))
                .toList();
        return NAMES.entrySet().stream()
                .filter(name -> terms.contains(name.getKey()) && Charset.isSupported(name.getValue()))
                .findFirst()
                .map(name -> Charset.forName(name.getValue()))
                .orElse(StandardCharsets.ISO_8859_1);
    }

    /** The text of bytes, without the escape sequences in it. */
    static String text(byte[] bytes, Charset charset) {
        StringBuilder text = new StringBuilder();
        int from = 0;
        for (int i = 1; i <= bytes.length; i++) {
            if (i == bytes.length || bytes[i] == ESC) {
                byte[] piece = Arrays.copyOfRange(bytes, from, i);
                text.append(new String(piece, isKatakana(piece, charset) ? Charset.forName(KATAKANA) : charset));
                from = i;
            }
        }
        return ESCAPE.matcher(text).replaceAll("");
    }

    /** Whether bytes, which an escape sequence may begin, are of no character of ISO-2022-JP, which has 7 bits. */
    private static boolean isKatakana(byte[] bytes, Charset charset) {
        boolean eightBits = false;
        for (byte one : bytes) {
            eightBits |= Byte.toUnsignedInt(one) > LAST_OF_ASCII;
        }
        return eightBits && charset.name().equals("ISO-2022-JP") && Charset.isSupported(KATAKANA);
    }
}
