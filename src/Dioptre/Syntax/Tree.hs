{-# LANGUAGE DerivingStrategies #-}

-- |
-- Module      : Dioptre.Syntax.Tree
-- Description : What a file says, before anyone asks whether it makes sense
--
-- The syntax tree of a scene or configuration file: objects, one inside another, and properties with the text of their
-- values. Every node knows its place. Nothing is refused here: a tree is made from any text whatever, and it keeps what
-- is odd about it (an @end@ too many, a comment never closed) for the checker to tell.
--
-- > primitive              Block "primitive"
-- >   material_name red      Property "material_name" "red"
-- >   sphere                 Block "sphere"
-- >     ray 2.0                Property "ray" "2.0"
-- >   end                      closed ByEnd
-- > end                      closed ByEnd
module Dioptre.Syntax.Tree
  ( Tree,
    Node (..),
    Block (..),
    Closing (..),
    Property (..),
    Head (..),
    Value (..),
  )
where

import Data.Text (Text)
import Dioptre.Source.Span (Span)
import Dioptre.Syntax.Keyword (Keyword)

-- | A whole file, in its order.
type Tree = [Node]

-- | One thing that a file says.
data Node
  = Object Block
  | Statement Property
  | -- | An @end@ where nothing is open.
    LooseEnd Head
  | -- | A block comment that is never closed, at the place where it opens.
    OpenComment Span
  deriving stock (Eq, Show)

-- | An object: the word that opens it, what stands in it, and how it ends.
data Block = Block
  { blockHead :: Head,
    -- | What stands behind that word on its line, and says nothing.
    blockRest :: Value,
    blockNodes :: [Node],
    blockClosing :: Closing
  }
  deriving stock (Eq, Show)

-- | How an object ends.
data Closing
  = -- | By its @end@, which stands there.
    ByEnd Span
  | -- | By a lone word that is @end@ but for one slip of the finger.
    ByMisspeltEnd Head
  | -- | By a word that opens an object of the scene.
    BySceneWord Head
  | -- | By the end of the file.
    ByEndOfFile
  deriving stock (Eq, Show)

-- | A property: its word and what follows on the line.
data Property = Property
  { propertyHead :: Head,
    propertyValue :: Value
  }
  deriving stock (Eq, Show)

-- | The first word of a line, as it is written, and which word of the language it is, if it is one.
data Head = Head
  { headSpan :: Span,
    headText :: Text,
    headKeyword :: Maybe Keyword
  }
  deriving stock (Eq, Ord, Show)

-- | The rest of a line, from its first character that is not blank; blanks at its end belong to it.
data Value = Value
  { valueSpan :: Span,
    valueText :: Text
  }
  deriving stock (Eq, Ord, Show)
