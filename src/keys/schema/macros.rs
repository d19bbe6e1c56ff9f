//! The macros that declare tables, tables of several kinds, and words.

/// Declares a table of a file: a struct with one public field a key, read and written as a
/// [`TableType`](super::TableType). The doc comment of a key is its line of help.
///
/// ```text
/// table! {
///     /// A section of the line.
///     pub struct Section => SectionKeys {
///         /// Unstretched length.
///         length_m: f64, "length", range positive(1e5);
///         /// Mass of all of them.
///         mass_kg: f64 = 0.0, "mass", range of(0.0, 1e9);
///         /// Where the stretch ends.
///         to_m: Option<f64>, "to", range positive(1e5), absent "the section's end";
///     }
///     tables {
///         /// The form of the payload.
///         shape: Option<Shape>;
///     }
/// }
/// ```
///
/// A key has its type, its default after `=`, and its label; then, in this order and each only where it says something:
///
/// - `kind k`: what may be written, where the type alone does not say it (`kind Name` for a `String`);
/// - `unit "m"`: the unit, where the name of the key does not end in it;
/// - `range r`: the range of its numbers;
/// - `absent "…"`: what holds without it, in words;
/// - `unless other`: required unless this other key is given;
/// - `only key "word"`: the key exists only in tables where that other key is that word;
/// - `matters needs`: the key matters only where other keys of its table are certain words.
///
/// A key is required that has neither a default nor `absent`. Tables in the table follow: their type says how many there
/// are (`T`, `Option<T>`, `BTreeMap<String, T>`, `Vec<T>`), `required` that none is too few, `as "key"` a key that differs from the field, `optional` that a table left
/// out is one with all defaults, `alike` that several tables have the same fields, below `*`. `SectionKeys` holds the same keys as they are read, each with its place.
#[macro_export]
macro_rules! table {
    (
        $(#[$meta:meta])*
        pub struct $name:ident => $keys:ident {
            $(
                #[doc = $help:literal]
                $key:ident: $type:ty $(= $default:expr)?, $label:literal
                $(, kind $kind:expr)?
                $(, unit $unit:literal)?
                $(, range $range:expr)?
                $(, absent $absent:expr)?
                $(, unless $unless:ident)?
                $(, only $tag:ident $word:literal)?
                $(, matters $needs:expr)?;
            )*
        }
        $(tables {
            $(
                #[doc = $table_help:literal]
                $table:ident: $table_type:ty $(as $named:literal)? $(, $presence:ident)?;
            )*
        })?
    ) => {
        $(#[$meta])*
        pub struct $name {
            $( #[doc = $help] pub $key: $type, )*
            $($( #[doc = $table_help] pub $table: $table_type, )*)?
        }

        #[doc = concat!("The keys of [`", stringify!($name), "`] as they are read.")]
        #[derive(Debug)]
        pub struct $keys<'a> {
            /// Where they stand.
            pub place: $crate::schema::TableNode<'a>,
            $( #[doc = $help] pub $key: $crate::schema::Key<'a, <$type as $crate::schema::FieldType>::Given>, )*
            $($( #[doc = $table_help] pub $table: <$table_type as $crate::schema::SubTable>::Keys<'a>, )*)?
        }

        impl $name {
            /// The keys, in the order of their declaration.
            fn fields() -> &'static [$crate::fields::Field] {
                static FIELDS: std::sync::LazyLock<Vec<$crate::fields::Field>> = std::sync::LazyLock::new(|| vec![
                    $(
                        $crate::fields::Field {
                            $( absent: $crate::fields::AbsentValue::Default({
                                let value: <$type as $crate::schema::FieldType>::Given =
                                    $crate::schema::FromDefault::from_default($default);
                                $crate::schema::KeyValue::default_text(&value, stringify!($default))
                            }), )?
                            $( kind: $kind, )?
                            $( unit: $unit, )?
                            $( range: $range, )?
                            $( absent: $crate::fields::AbsentValue::Means($absent), )?
                            $( absent: $crate::fields::AbsentValue::RequiredWithout(stringify!($unless)), )?
                            $( only_if: Some((stringify!($tag), $word)), )?
                            $( matters: $needs, )?
                            ..$crate::fields::Field::new(
                                stringify!($key),
                                <<$type as $crate::schema::FieldType>::Given as $crate::schema::KeyValue>::KIND,
                                $label,
                                $help.trim_ascii(),
                            )
                        },
                    )*
                ]);
                &FIELDS
            }
        }

        /// The defaults; a required key holds 0, nothing or the first of its words.
        impl Default for $name {
            fn default() -> Self {
                Self {
                    $( $key: $crate::schema::FieldType::or_blank(
                        None $( .or(Some($crate::schema::FromDefault::from_default($default))) )?,
                    ), )*
                    $($( $table: Default::default(), )*)?
                }
            }
        }

        impl $crate::schema::TableType for $name {
            type Keys<'a> = $keys<'a>;

            fn declare(pattern: &str, schema: &mut $crate::schema::DeclaredSchema) {
                schema.fields(pattern, Self::fields());
                $($(
                    let presence = [$(stringify!($presence))?];
                    schema.table::<$table_type>(pattern, [$($named,)? stringify!($table)][0], presence.first(), $table_help.trim_ascii());
                )*)?
            }

            fn keys<'a>(place: &$crate::schema::TableNode<'a>) -> $keys<'a> {
                $keys {
                    $( $key: $crate::schema::Key::read(
                        place,
                        stringify!($key),
                        Self::fields(),
                        None $( .or(Some($crate::schema::FromDefault::from_default($default))) )?,
                    ), )*
                    $($( $table: <$table_type as $crate::schema::SubTable>::keys(place, [$($named,)? stringify!($table)][0]), )*)?
                    place: place.clone(),
                }
            }

            fn from_keys(keys: &$keys<'_>) -> Result<Self, $crate::Finding> {
                Ok(Self {
                    $( $key: $crate::schema::FieldType::hold(keys.$key.value())
                        .ok_or_else(|| keys.place.faulty(stringify!($key)))?, )*
                    $($( $table: <$table_type as $crate::schema::SubTable>::from_keys(
                        &keys.$table,
                        &keys.place,
                        [$($named,)? stringify!($table)][0],
                    )?, )*)?
                })
            }

            fn write(&self, written: $crate::schema::WrittenKeys) -> $crate::toml_edit::Table {
                let mut table = $crate::toml_edit::Table::new();
                $( $crate::schema::put(
                    &mut table,
                    stringify!($key),
                    &self.$key,
                    None $( .or(Some($crate::schema::FromDefault::from_default($default))) )?,
                    written,
                ); )*
                $($(
                    if let Some(inner) = $crate::schema::SubTable::write(&self.$table, written) {
                        table.insert([$($named,)? stringify!($table)][0], inner);
                    }
                )*)?
                table
            }
        }
    };
}
pub use table;

/// Declares words that a key can be: an enum of units with the word of each, `ALL` of them, and `name`.
///
/// ```text
/// words! {
///     /// How friction of the bed acts.
///     #[derive(Default)]
///     pub enum FrictionLaw {
///         /// Holds at rest by a spring.
///         #[default]
///         Grip = "grip",
///         /// Against the velocity.
///         Zhu2017 = "zhu-2017",
///     }
/// }
/// ```
#[macro_export]
macro_rules! words {
    (
        $(#[$meta:meta])*
        pub enum $name:ident {
            $( $(#[$of:meta])* $variant:ident = $word:literal, )*
        }
    ) => {
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        pub enum $name {
            $( $(#[$of])* $variant, )*
        }

        impl $name {
            /// All of them, in the order in which they are explained to users.
            pub const ALL: [Self; [$($word),*].len()] = [$(Self::$variant),*];

            /// The word for it in files.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $( Self::$variant => $word, )*
                }
            }
        }

        impl $crate::schema::KeyValue for $name {
            const KIND: $crate::fields::ValueType = $crate::fields::ValueType::Choice(&[$($word),*]);

            fn blank() -> Self {
                Self::ALL[0]
            }

            fn read(node: &$crate::TomlNode) -> Option<Self> {
                match node.text()? {
                    $( $word => Some(Self::$variant), )*
                    _ => None,
                }
            }

            fn write(&self) -> $crate::toml_edit::Value {
                self.name().into()
            }

            fn default_text(&self, _declared: &'static str) -> &'static str {
                match self {
                    $( Self::$variant => concat!("\"", $word, "\""), )*
                }
            }
        }

        impl $crate::schema::FromDefault<Self> for $name {
            fn from_default(declared: Self) -> Self {
                declared
            }
        }
    };
}
pub use words;

/// Declares a table of several kinds, told apart by the word of one of its keys: an enum over tables that are declared
/// with [`table!`]. Keys that all kinds declare alike belong to the table whatever its kind.
///
/// ```text
/// variants! {
///     /// The form of a payload.
///     pub enum Shape => ShapeKeys by kind, "shape", "Form of the payload." {
///         /// A box.
///         Box(BoxShape) = "box",
///     }
/// }
/// ```
#[macro_export]
macro_rules! variants {
    (
        $(#[$meta:meta])*
        pub enum $name:ident => $keys:ident by $tag:ident, $label:literal, $help:literal {
            $( #[doc = $of:literal] $variant:ident($inner:ty) = $word:literal, )*
        }
    ) => {
        $(#[$meta])*
        #[derive(Debug, Clone, PartialEq)]
        pub enum $name {
            $( #[doc = $of] $variant($inner), )*
        }

        #[doc = concat!("The keys of a [`", stringify!($name), "`] as they are read.")]
        #[derive(Debug)]
        pub enum $keys<'a> {
            /// The kind is faulty or missing.
            Unknown($crate::schema::TableNode<'a>),
            $( #[doc = $of] $variant(Box<<$inner as $crate::schema::TableType>::Keys<'a>>), )*
        }

        impl $crate::schema::TableType for $name {
            type Keys<'a> = $keys<'a>;

            fn declare(pattern: &str, schema: &mut $crate::schema::DeclaredSchema) {
                let kinds = [$( ($word, $crate::schema::DeclaredSchema::of_table::<$inner>()) ),*];
                let words: &'static [&'static str] = &[$($word),*];
                let tag = $crate::fields::Field::new(
                    stringify!($tag),
                    $crate::fields::ValueType::Choice(words),
                    $label,
                    $help,
                );
                schema.kinds(pattern, (stringify!($tag), tag), &kinds);
            }

            fn keys<'a>(place: &$crate::schema::TableNode<'a>) -> $keys<'a> {
                match place.node.get(stringify!($tag)).and_then($crate::TomlNode::text) {
                    $( Some($word) => $keys::$variant(Box::new(<$inner as $crate::schema::TableType>::keys(place))), )*
                    _ => $keys::Unknown(place.clone()),
                }
            }

            fn from_keys(keys: &$keys<'_>) -> Result<Self, $crate::Finding> {
                match keys {
                    $keys::Unknown(place) => Err(place.faulty(stringify!($tag))),
                    $( $keys::$variant(inner) => <$inner as $crate::schema::TableType>::from_keys(inner).map(Self::$variant), )*
                }
            }

            fn write(&self, written: $crate::schema::WrittenKeys) -> $crate::toml_edit::Table {
                let (word, inner) = match self {
                    $( Self::$variant(inner) => ($word, $crate::schema::TableType::write(inner, written)), )*
                };
                let mut table = $crate::toml_edit::Table::new();
                table.insert(stringify!($tag), $crate::toml_edit::value(word));
                for (key, item) in inner {
                    table.insert(&key, item);
                }
                table
            }
        }
    };
}
pub use variants;
