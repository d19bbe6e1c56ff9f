//! What a printed page holds, as far as its objects say so in plain text.

/// A PDF file.
pub(crate) struct Pdf {
    /// Width and height of every page [pt].
    pub(crate) pages: Vec<(f64, f64)>,
    /// Raster images.
    pub(crate) images: usize,
    /// Fonts, which words have and pictures of words do not.
    pub(crate) fonts: usize,
    /// Size of the file.
    pub(crate) bytes: usize,
}

impl Pdf {
    /// Reads a file that Chromium wrote, in which dictionaries are not compressed.
    pub(crate) fn new(bytes: &[u8]) -> Self {
        let text = String::from_utf8_lossy(bytes);
        assert!(text.starts_with("%PDF"));
        let count = |word: &str| text.matches(word).count();
        let boxes = text.split("/MediaBox [").skip(1);
        let pages = boxes.map(|rest| {
            let numbers = rest.split(']').next().unwrap().split_whitespace();
            let numbers: Vec<f64> = numbers.map(|number| number.parse().unwrap()).collect();
            assert_eq!(numbers.len(), 4);
            (numbers[2] - numbers[0], numbers[3] - numbers[1])
        });
        let pages: Vec<(f64, f64)> = pages.collect();
        assert_eq!(pages.len(), count("/Type /Page\n"));
        Self {
            pages,
            images: count("/Subtype /Image"),
            fonts: count("/Type /Font\n"),
            bytes: bytes.len(),
        }
    }
}
